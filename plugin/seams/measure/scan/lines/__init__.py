"""The lines of a scan: seams traced from labels or given by producers, cut in pieces that are measured one by one."""
