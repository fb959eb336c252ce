"""How slow a machine the tests put up with. The goals are printed with what was measured; these bounds only tell a
broken promise (work done in the interface's thread) from a machine that is slow, or busy with something else."""
from __future__ import annotations

MOST_WORK_S = 0.25  # time of the interface's thread without a turn of its event loop; the goal is 0.05
MOST_GAP_S = 3.0  # time without a turn by the clock, which on a shared machine runs for others too
PATIENCE_S = 120.0  # for tasks, charts and messages that are waited for
