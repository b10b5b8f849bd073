"""The bill of materials of the packages, as SPDX 2.3 in JSON: bill_of_materials.py BUILD DEBIAN VERSION

BUILD is the folder that ninja has built in, DEBIAN the folder with one tree per package. Writes opal.spdx.json into the
package opal, and into each package the copyright files of what is inside its own files.
"""

import datetime
import hashlib
import json
import os
import pathlib
import re
import sys

import built_parts
import package_licences

# Every program of GCC and the C library has these; their licences make an exception for what is compiled with them.
COMPILER = re.compile(r"^(libc6-dev|linux-libc-dev|libgcc-\d+-dev|libstdc\+\+-\d+-dev)$")


def spdx_id(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.]", "-", name.replace("+", "p"))


class Bill:
    """Packages of Opal, packages of Debian that they link or hold, and how they hang together."""

    def __init__(self, version):
        self.version = version
        self.packages, self.relations = {}, set()

    def add_own(self, name):
        self.packages[name] = {
            "name": name, "SPDXID": spdx_id(name), "versionInfo": self.version, "supplier": "Organization: Opal maintainers",
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": "NOASSERTION",
            "licenseDeclared": "Apache-2.0", "copyrightText": "NOASSERTION"}
        self.relations.add(("SPDXRef-DOCUMENT", "DESCRIBES", spdx_id(name)))

    def add_foreign(self, name):
        if name in self.packages:
            return
        version, (expression, names) = package_licences.version_of(name), package_licences.licences(name)
        self.packages[name] = {
            "name": name, "SPDXID": spdx_id(name), "versionInfo": version, "supplier": "Organization: Debian",
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": "NOASSERTION",
            "licenseDeclared": expression, "copyrightText": "NOASSERTION",
            "licenseComments": "Debian's copyright file names: " + ("; ".join(names) or "nothing that a program can read"),
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:deb/debian/{name}@{version}"}]}

    def relate(self, own, kind, other):
        if other != own:
            self.relations.add((spdx_id(own), kind, spdx_id(other)))

    def document(self):
        packages = [self.packages[name] for name in sorted(self.packages)]
        relations = [{"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}
                     for one, kind, other in sorted(self.relations)]
        digest = hashlib.sha256(json.dumps([packages, relations]).encode()).hexdigest()[:32]
        moment = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", 0)), datetime.timezone.utc)
        return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"opal-{self.version}",
                "documentNamespace": f"urn:opal:spdx:{self.version}:{digest}",
                "creationInfo": {"created": moment.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Tool: bill_of_materials.py"]},
                "comment": "DYNAMIC_LINK: a library that files of the package name. STATIC_LINK: an archive that is linked into them. "
                           "CONTAINS: headers that were compiled into them, or scripts in pages that they write.",
                "packages": packages, "relationships": relations}


def target_of(path, build):
    """The file of the build that was installed as `path`."""
    name = re.sub(r"\.so\.[\d.]+$", ".so", path.name)
    for folder in ("bin", "lib", "plugins", "python/opal"):
        if (build.folder / folder / name).exists():
            return f"{folder}/{name}"
    raise SystemExit(f"{path}: is in a package, and {build.folder} has no file of that name")


def add_links(bill, own, files, own_libraries):
    sonames = sorted({name for file in files for name in built_parts.needed(file)})
    places = built_parts.library_paths()
    owners = package_licences.owners_of_libraries({name: places[name] for name in sonames if name in places})
    for soname in sonames:
        other = own_libraries.get(soname) or owners.get(soname)
        if other is None:
            raise SystemExit(f"{own}: links {soname}, which no package has")
        if soname not in own_libraries:
            bill.add_foreign(other)
        bill.relate(own, "DYNAMIC_LINK", other)


def add_contents(bill, own, files, build):
    """@return  the packages whose code is inside of these files."""
    archives, headers, scripts = set(), set(), set()
    for file in files:
        found_archives, found_headers, rooms = build.parts_of(target_of(file, build))
        archives |= found_archives
        headers |= found_headers
        scripts |= set().union(*map(build.scripts_of, sorted(rooms)))
    held = set()
    for kind, paths in (("STATIC_LINK", archives), ("CONTAINS", headers | scripts)):
        for other in set(package_licences.owners(paths).values()):
            bill.add_foreign(other)
            bill.relate(own, kind, other)
            held.add(other)
    return held


def write_notices(folder, own, held):
    """Licences that ask for their text beside the program are kept by this."""
    held = sorted(name for name in held if not COMPILER.match(name))
    if not held:
        return
    parts = [f"{'=' * 78}\n{name}, inside of files of this package\n{'=' * 78}\n"
             + package_licences.copyright_file(name).read_text(errors="replace") for name in held]
    place = folder / "usr/share/doc" / own / "inside.copyright"
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text("\n".join(parts))


def main():
    build, debian, version = built_parts.Build(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    own = re.findall(r"^Package: (\S+)$", (debian / "control").read_text(), re.MULTILINE)
    files = {name: built_parts.elf_files(debian / name) for name in own if (debian / name).is_dir()}
    own_libraries = {re.sub(r"(\.so\.\d+)\..*", r"\1", file.name): name for name in files for file in files[name]}
    bill = Bill(version)
    for name in files:
        bill.add_own(name)
    for name, its_files in files.items():
        add_links(bill, name, its_files, own_libraries)
        write_notices(debian / name, name, add_contents(bill, name, its_files, build))
    place = debian / "opal/usr/share/doc/opal/opal.spdx.json"
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(json.dumps(bill.document(), indent=1) + "\n")
    print(f"{len(bill.packages)} packages, {len(bill.relations)} relations in {place}")


main()
