# Seam Inspector: `make help` lists the targets.

PYTHON := .venv/bin/python
PYTHON_QT6 := .venv-qt6/bin/python
PACKAGE := build/plugins/seam_inspector
# Tests of one file share what they make, so a file goes to one process; those with slow tests come first
SIDE_BY_SIDE := -n auto --maxprocesses 4 --dist loadfile --no-loadscope-reorder
# The real application waits as often as it works, so that one process more than there are cores keeps them busy
WITH_DESKTOP := -n $(shell expr `nproc` + 1) --maxprocesses 5 --dist loadfile --no-loadscope-reorder
# Processes side by side take the cores already
ONE_THREAD := OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
# Tests of what draws and listens, which ask little of QGIS; those that ask more are skipped
ALSO_UNDER_QT6 := $(addprefix tests/qgis/,$(addprefix seams/desk/,judging profile/test_profile_panel.py \
	test_curves_panel.py test_windows_panel.py) $(addprefix toolkit/,test_attribute_values.py test_latest_only.py \
	test_numbers_in_words.py test_painting.py test_widgets.py))
# Of Qt 5 or 6, whichever there is: the compiled file is the same
LRELEASE = $(firstword $(shell command -v lrelease lrelease-qt5 lrelease-qt6 /usr/lib/qt6/bin/lrelease) lrelease)
TRANSLATIONS := $(patsubst %.ts,%.qm,$(wildcard i18n/*.ts))

# QGIS and Python find the package by its name, not by the checkout's
export QGIS_PLUGINPATH := $(CURDIR)/build/plugins
export PYTHONPATH := $(CURDIR)/build/plugins

ifndef SIDE_BY_SIDE_TARGETS
.NOTPARALLEL:
endif
.PHONY: help install link lint check test mutants test-numbers test-release test-qt6 test-in-qgis test-release-in-qgis test-qgis test-desktop test-matrix guide help-pages check-links pictures demo demo-pictures benchmark speed benchmark-scan benchmark-mending benchmark-detection benchmark-compressed benchmark-compressed-scans benchmark-deliveries benchmark-programs benchmark-constants benchmark-calibration fuzz soak translate package icon clean

help: ## Show this list
	@sed -n 's/^\([a-z0-9-]*\):.*## /\1\t/p' Makefile | expand -t 22

install: ## Install what the other targets need; does nothing when it is all there
	@tools/install.sh

link: install $(PACKAGE) $(TRANSLATIONS) ## Make the checkout importable as seam_inspector

$(PACKAGE):
	@mkdir -p $(@D)
	@ln -sfn ../.. $@

%.qm: %.ts
	$(LRELEASE) -silent $< -qm $@

lint: link ## Check style and types, and that nothing is left unused
	$(PYTHON) -m ruff check .
	$(PYTHON) -m vulture
	$(PYTHON) -m tools.rooms
	$(PYTHON) -m mypy -p seam_inspector.plugin -p seam_inspector.python $(patsubst %/run.py,-p %,$(wildcard demo/run.py benchmarks/run.py fuzz/run.py))

check: lint ## Before every commit, in two minutes: style, types, and the quick tests of the numbers
	$(ONE_THREAD) $(PYTHON) -m pytest -q -p no:pytest_qgis $(SIDE_BY_SIDE) --quick tests/numbers

# Types and what needs no QGIS are a process each, so two of these go side by side; tests take all processors themselves
test: link ## Check style and types, then run all tests but those of a release
	$(MAKE) --jobs 2 --output-sync=target SIDE_BY_SIDE_TARGETS=1 lint test-qt6
	$(MAKE) test-numbers test-in-qgis

test-numbers: link ## Run the tests of the numbers, without QGIS
	$(ONE_THREAD) $(PYTHON) -m pytest -p no:pytest_qgis $(SIDE_BY_SIDE) -m "not release" tests/numbers

test-release: link ## Run the tests that only a release asks for, after make test: large statistics, killed processes, much real data
	$(ONE_THREAD) $(PYTHON) -m pytest -p no:pytest_qgis $(SIDE_BY_SIDE) -m release tests/numbers
	$(MAKE) test-release-in-qgis

test-qt6: link ## Hold the code against Qt 6 and QGIS 4: names, types, and what draws without QGIS; against the newest scipy
	@tools/install_qt6.sh
	$(PYTHON_QT6) -m tools.qt6.check_names
	$(PYTHON_QT6) -m tools.qt6.check_types
	QT_QPA_PLATFORM=offscreen PYTHONPATH=$(PYTHONPATH):$(CURDIR) $(PYTHON_QT6) -m pytest -q -p tests.qt6.under_qt6 \
		--confcutdir tests/qgis/seams tests/qt6 $(ALSO_UNDER_QT6)
	$(ONE_THREAD) $(PYTHON_QT6) -m pytest -q tests/numbers/test_called_in_threads.py  # with the newest scipy

test-in-qgis: link ## Run the tests inside QGIS and those of the real application side by side
	@rm -rf .qgis-settings
	QT_QPA_PLATFORM=offscreen $(ONE_THREAD) $(PYTHON) -m pytest $(WITH_DESKTOP) -m "not stalls and not release" \
		tests/qgis tests/desktop

test-release-in-qgis: link ## Run what test-in-qgis leaves to the days before a release; what measures stalls comes last, alone
	@rm -rf .qgis-settings
	QT_QPA_PLATFORM=offscreen $(ONE_THREAD) $(PYTHON) -m pytest $(WITH_DESKTOP) -m "release and not stalls" \
		tests/qgis tests/desktop
	$(PYTHON) -m pytest -p no:pytest_qgis -n 1 -m stalls tests/desktop

test-qgis: link ## Run the tests inside QGIS, offscreen
	@rm -rf .qgis-settings
	QT_QPA_PLATFORM=offscreen $(ONE_THREAD) $(PYTHON) -m pytest $(SIDE_BY_SIDE) -m "not release" tests/qgis

test-desktop: link ## Run the tests of the real application, each on a virtual screen of its own
	$(PYTHON) -m pytest -p no:pytest_qgis -n auto --maxprocesses 4 --dist worksteal -m "not stalls and not release" tests/desktop

mutants: link ## Change the measuring code at random, and tell which changes no test sees: N=40 SEED=1
	$(ONE_THREAD) $(PYTHON) -m tools.mutants $(if $(N),--count $(N)) $(if $(SEED),--seed $(SEED))

test-matrix: link ## Run the tests on the QGIS of this machine, of Debian trixie and of sid, in chroots; FULL=1 for all of them, SUITES=qt6 QT6=folder or tarball for a QGIS on Qt 6
	$(PYTHON) -m tools.qgis_matrix.run $(if $(FULL),--full) $(if $(MIRROR),--mirror "$(MIRROR)") \
		$(if $(SUITES),--suites "$(SUITES)") $(if $(QT6),--qt6 "$(QT6)") $(if $(CHROOTS),--chroots "$(CHROOTS)")

guide: link ## Make the guide of docs, in build/guide/index.html
	$(PYTHON) -m sphinx -W --keep-going -q -j auto -b html docs build/guide

help-pages: link ## Make anew what the guide has from the code (tables of the algorithms, the desk's keys, reference and notebook of Python), and the plugin's help
	QT_QPA_PLATFORM=offscreen $(PYTHON) tools/algorithm_tables.py
	$(PYTHON) -m tools.python_pages
	$(PYTHON) tools/keys_table.py
	$(PYTHON) tools/help_pages.py

pictures: link ## Make the guide's pictures of the plugin anew, of what `make demo` left and, by SEAM_INSPECTOR_DATA, of real data
	$(PYTHON) -m demo.guide --block output/demo/block --output docs/pictures \
		--brighton "$${SEAM_INSPECTOR_DATA:-../shared/data}/seams/brighton"

check-links: link ## Follow the guide's links to other sites, by the network
	$(PYTHON) -m sphinx -q -b linkcheck docs build/links

demo: $(PACKAGE) ## Inspect a generated block, or with DATA=folder your own rasters; results in output/demo
	@tools/install.sh demo
	@QT_QPA_PLATFORM=offscreen /usr/bin/python3 -m demo.run --output output/demo $(if $(DATA),--data "$(DATA)") \
		$(if $(SIDE),--side $(SIDE)) $(if $(SPACING),--spacing $(SPACING))

demo-pictures: link demo ## Play the desk on the generated block in the real QGIS, for pictures of it in output/demo; takes some minutes
	@$(PYTHON) -m demo.screenshot --block output/demo/block --output output/demo

.PHONY: demo-data
demo-data: link ## Make all data that the examples of docs/algorithms take, in output/demo
	QT_QPA_PLATFORM=offscreen $(PYTHON) -m demo.data output/demo

benchmark: link ## Measure the speed, on one core
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 GDAL_NUM_THREADS=1 $(PYTHON) -m benchmarks.run

speed: link ## Measure the guide's table of speed, three runs on one core, and write it there
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 GDAL_NUM_THREADS=1 $(PYTHON) -m benchmarks.speed --write docs/reference/speed.md

benchmark-scan: link ## Measure the scan of a whole mosaic against the bare read of its files, on all cores, as a user runs it; SIDE=3000 for a try
	$(PYTHON) -m benchmarks.scan $(if $(SIDE),--side $(SIDE))

benchmark-mending: link ## Measure seams cut anew against the scan that found them, on all cores, as a user runs it; SIDE=3000 for a try
	$(PYTHON) -m benchmarks.mending $(if $(SIDE),--side $(SIDE))

benchmark-detection: link ## Measure how well lost contrast and its causes are found, on all cores: WINDOWS=1 SIDE=256 HALF=used for a try; real data by SEAM_INSPECTOR_DATA
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.detection $(if $(WINDOWS),--windows $(WINDOWS)) \
		$(if $(SIDE),--side $(SIDE)) $(if $(HALF),--half "$(HALF)")

benchmark-compressed: link ## Measure how truly compressed deliveries are judged, on all cores: HALF="held back", SHARE=0.1 for a try; real data by SEAM_INSPECTOR_DATA
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.compressed $(if $(HALF),--half "$(HALF)") \
		$(if $(SHARE),--share $(SHARE))

benchmark-compressed-scans: link ## Measure how truly scans judge compressed deliveries, some twenty minutes: HALF="held back", IMAGERY=block
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.compressed_scans \
		$(if $(HALF),--half "$(HALF)") $(if $(IMAGERY),--imagery $(IMAGERY))

benchmark-deliveries: link ## Decide on twelve deliveries whose truth is planted, some ten minutes: ONLY=block for a try; real data by SEAM_INSPECTOR_DATA
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.deliveries $(if $(ONLY),--only "$(ONLY)")

benchmark-programs: link ## Measure what OTB, SAGA, GDAL, GRASS, enblend, rasterio and OpenCV keep along seams, after installing them: WINDOWS=1 IMAGERY=brighton SIDE=256 ONLY=OTB for a try; real data by SEAM_INSPECTOR_DATA
	@tools/install_programs.sh
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.programs $(if $(WINDOWS),--windows $(WINDOWS)) \
		$(if $(SIDE),--side $(SIDE)) $(if $(IMAGERY),--imagery "$(IMAGERY)") $(if $(ONLY),--only "$(ONLY)")

benchmark-constants: link ## Measure what becomes of verdicts when a constant that judges is halved or doubled, and write the guide's table; ONLY=following for a try; real data by SEAM_INSPECTOR_DATA
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.constants $(if $(ONLY),--only "$(ONLY)",--write docs/appendix/constants.md)

benchmark-calibration: link ## Measure how often the calibration's range covers the true threshold; takes an hour
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(PYTHON) -m benchmarks.calibration

fuzz: link ## Play broken inputs through every algorithm: MINUTES=10 SEED=1 ALGORITHM=report; CASE=... for a finding
	$(PYTHON) -m fuzz.run $(if $(MINUTES),--minutes $(MINUTES)) $(if $(SEED),--seed $(SEED)) \
		$(if $(ALGORITHM),--algorithm $(ALGORITHM)) $(if $(CASE),--case "$(CASE)")

translate: link ## Collect new texts into the translations, then compile them
	$(PYTHON) -m tools.collect_translations i18n/seam_inspector_pl.ts
	$(MAKE) link

soak: link ## Inspect 5,000 windows and judge 500 in the real application, and tell what grows; FEWER=20 for a try
	$(PYTHON) -m tests.desktop.soak $(if $(FEWER),--fewer $(FEWER))

package: ## Make the plugin's zip and the wheel for Python without QGIS of the last commit, in build/, and check the zip
	@tools/install.sh package
	@python=$(PYTHON); [ -e .venv/stamp ] || python=.venv-package/bin/python; \
		zip=$$("$$python" -m tools.make_package) && wheel=$$("$$python" -m tools.make_wheel) && \
		"$$python" -m tools.check_package "$$zip" && echo "$$zip" && echo "$$wheel"

icon: link ## Draw the PNG of the icon anew from its SVG
	QT_QPA_PLATFORM=offscreen $(PYTHON) tools/draw_icon.py

clean: ## Remove what was built; .venv and the chroots of test-matrix stay
	[ ! -d build ] || find build -mindepth 1 -maxdepth 1 -not -name chroots -exec rm -rf {} +
	rm -rf output .qgis-settings .mypy_cache .pytest_cache .ruff_cache .hypothesis i18n/*.qm
	find . -name __pycache__ -not -path './.venv*/*' -not -path './build/*' -prune -exec rm -rf {} +
