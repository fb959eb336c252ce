"""The Python interface: arrays, tables, executors and the command line, over what the plugin measures with."""
