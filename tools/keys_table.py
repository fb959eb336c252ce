"""Write the table of the desk's keys into docs/desk/desk.md, between the marks `<!-- keys -->` and their end."""
from __future__ import annotations

import re
from pathlib import Path

from seam_inspector.plugin.seams.desk.desk_keys import KEYS

PAGE = Path(__file__).parents[1] / "docs" / "desk" / "desk.md"


def with_keys(page: str) -> str:
    """The page with its table made anew; ValueError for one without the marks."""
    rows = [("key", "where", "what it does"), ("---",) * 3, *((line.shown, line.where, line.does) for line in KEYS)]
    table = "\n".join(f"| {' | '.join(row)} |" for row in rows)
    made, count = re.subn(
        r"<!-- keys -->\n.*?<!-- end of keys -->", lambda _: f"<!-- keys -->\n\n{table}\n\n<!-- end of keys -->", page,
        flags=re.DOTALL,
    )  # fmt: skip
    if count != 1:
        raise ValueError(f"{PAGE} has no marks for its table of keys.")
    return made


def main() -> None:
    PAGE.write_text(with_keys(PAGE.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
