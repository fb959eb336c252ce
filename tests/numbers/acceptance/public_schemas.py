"""The published XML schemas of ISO 19115-3 and ISO/TS 19157-2, with GML 3.2.1: what a record is held against.

They come with the package ckanext-iso19115 of requirements-dev.txt, of which nothing else is used. The one schema that
it leaves to the network, W3C's of XLink, is written out below as far as these schemas name it.
"""
from __future__ import annotations

from importlib.metadata import distribution
from pathlib import Path

from lxml import etree

_ISO = "http://standards.iso.org/iso"
NAMESPACES = {
    **{name: f"{_ISO}/19115/-3/{name}/1.0" for name in ("gco", "gex", "lan", "mcc", "mri", "mrs")},
    **{name: f"{_ISO}/19115/-3/{name}/2.0" for name in ("cit", "mdb", "mrl")},
    "mdq": f"{_ISO}/19157/-2/mdq/1.0",
    "xlink": "http://www.w3.org/1999/xlink",
    "xsi": "http://www.w3.org/2001/XMLSchema-instance",
}
_XLINK = b"""<schema xmlns="http://www.w3.org/2001/XMLSchema" xmlns:xlink="http://www.w3.org/1999/xlink"
    targetNamespace="http://www.w3.org/1999/xlink">
  <attribute name="href" type="anyURI"/> <attribute name="role" type="anyURI"/>
  <attribute name="arcrole" type="anyURI"/> <attribute name="title" type="string"/>
  <attribute name="show"><simpleType><restriction base="token"><enumeration value="new"/><enumeration value="replace"/>
    <enumeration value="embed"/><enumeration value="other"/><enumeration value="none"/></restriction></simpleType>
  </attribute>
  <attribute name="actuate"><simpleType><restriction base="token"><enumeration value="onLoad"/>
    <enumeration value="onRequest"/><enumeration value="other"/><enumeration value="none"/></restriction></simpleType>
  </attribute>
  <attributeGroup name="simpleAttrs">
    <attribute name="type" type="string" form="qualified" fixed="simple"/>
    <attribute ref="xlink:href"/> <attribute ref="xlink:role"/> <attribute ref="xlink:arcrole"/>
    <attribute ref="xlink:title"/> <attribute ref="xlink:show"/> <attribute ref="xlink:actuate"/>
  </attributeGroup>
</schema>"""


class _Resolver(etree.Resolver):
    """Finds in the package what the schemas import from elsewhere."""

    def resolve(self, address: str, _public: str, context: object) -> object:
        if address.endswith("xlink.xsd"):
            return self.resolve_string(_XLINK, context)
        for start, folder in (("http://schemas.opengis.net/", "schemas.opengis.net/"), (f"{_ISO}/", "")):
            if address.startswith(start):
                return self.resolve_filename(str(_folder() / folder / address[len(start) :]), context)
        return None


def _folder() -> Path:
    return Path(str(distribution("ckanext-iso19115").locate_file("ckanext/iso19115/namespaces")))


def _schema() -> etree.XMLSchema:
    """Read anew each time: SpatiaLite frees the types of all schemas in a shared libxml2 as it ends."""
    parser = etree.XMLParser(no_network=True)
    parser.resolvers.add(_Resolver())
    imports = "".join(
        f'<import namespace="{_ISO}/{name}" schemaLocation="{(_folder() / name / path).as_uri()}"/>'
        for name, path in (("19115/-3/mdb/2.0", "mdb.xsd"), ("19157/-2/mdq/1.0", "mdq.xsd"))
    )
    root = f'<schema xmlns="http://www.w3.org/2001/XMLSchema">{imports}</schema>'
    return etree.XMLSchema(etree.fromstring(root.encode(), parser))


def faults(document: str) -> list[str]:
    """What of a record is not as the schemas ask, line by line, and links to nowhere in it; empty for a sound one."""
    schema, root = _schema(), etree.fromstring(document.encode())
    schema.validate(root)
    ids = {element.get("id") for element in root.iter()}
    links = (element.get(f"{{{NAMESPACES['xlink']}}}href", "") for element in root.iter())
    lost = [f"{link} leads nowhere" for link in links if link.startswith("#") and link[1:] not in ids]
    return [*(f"{error.line}: {error.message}" for error in schema.error_log), *lost]
