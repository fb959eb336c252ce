"""Every sentence that a user can be shown by the core, in one place, topic by topic.

A message keeps its template and its values apart, so that the adapters can translate the template
before the values are put in. ``str(message)`` is the English sentence. Each sentence says what is
wrong and what to do about it.
"""
from __future__ import annotations

from .enhancing import *  # noqa: F403
from .fiducials import *  # noqa: F403
from .inspection import *  # noqa: F403
from .message import Message as Message
from .noise import *  # noqa: F403
from .radiometry import *  # noqa: F403
from .resolution import *  # noqa: F403
from .sensors import *  # noqa: F403
