"""The tests on every QGIS, see CONTRIBUTING.md: `make test-matrix`."""
