"""What registries, archives and journals read of the project says the same everywhere: versions, licence, authors, the paper of the model.

Usage: metadata_test.py. Also: the description of a folder of results (RO-Crate 1.1) names what is in the folder, and everything it refers to.
"""
import json
import os
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
PAPER = "10.1007/s00603-013-0402-y"
LICENCE = "GPL-3.0-or-later"


def text(path):
    return (TOP / path).read_text()


def first(pattern, path):
    return re.search(pattern, text(path), re.M)[1]


class Metadata(unittest.TestCase):
    def setUp(self):
        self.codemeta = json.loads(text("codemeta.json"))

    def test_versions_are_those_of_the_build(self):
        version = first(r"^project\(graincrack VERSION (\S+)", "CMakeLists.txt")
        self.assertEqual(first(r"^version: (\S+)", "CITATION.cff"), version)
        self.assertEqual(self.codemeta["version"], version)
        self.assertEqual(first(r'^    version\("([^"]+)"', "share/packaging/spack/package.py"), version)
        self.assertEqual(first(r'^  version: "([^"]+)"', "share/packaging/conda/recipe.yaml"), version)
        self.assertEqual(first(r'^__version__ = "([^"]+)"', "share/python/graincrack/__init__.py"), version)
        released = first(r"^date-released: (\S+)", "CITATION.cff")
        self.assertIn(f"\n## {version}, {released}\n", text("CHANGELOG.md"))

    def test_authors_and_licence_are_those_of_the_citation(self):
        author = first(r"^  - name: (.+)", "CITATION.cff")
        self.assertEqual([each["name"] for each in self.codemeta["author"]], [author])
        self.assertEqual(first(r"^  - name: (.+)", "share/joss/paper.md"), author)
        self.assertEqual(first(r"^license: (\S+)", "CITATION.cff"), LICENCE)
        self.assertEqual(self.codemeta["license"], f"https://spdx.org/licenses/{LICENCE}")
        self.assertEqual(first(r'^    license\("([^"]+)"', "share/packaging/spack/package.py"), LICENCE)
        self.assertEqual(first(r"^  license: (\S+)", "share/packaging/conda/recipe.yaml"), LICENCE)

        self.assertEqual(first(r'^license = "([^"]+)"', "pyproject.toml"), LICENCE)

    def test_the_model_is_that_of_one_paper(self):
        self.assertEqual(self.codemeta["referencePublication"]["@id"], f"https://doi.org/{PAPER}")
        for path in ("CITATION.cff", "share/joss/paper.bib", "README.md"):
            self.assertIn(PAPER, text(path))

    def test_terms_of_codemeta_are_of_its_version_2(self):
        self.assertEqual(self.codemeta["@context"], "https://doi.org/10.5063/schema/codemeta-2.0")
        self.assertEqual(self.codemeta["@type"], "SoftwareSourceCode")
        known = {"applicationCategory", "author", "description", "developmentStatus", "keywords", "license", "name", "operatingSystem",
                 "programmingLanguage", "referencePublication", "runtimePlatform", "softwareHelp", "softwareRequirements", "version"}
        self.assertLessEqual({each for each in self.codemeta if each[0] != "@"}, known)

    def test_the_recipes_need_what_the_build_looks_for(self):
        looked_for = set(re.findall(r"find_package\((\w+)", text("CMakeLists.txt") + text("post/CMakeLists.txt")))
        looked_for |= set(re.findall(r'"([^"]+)"', first(r"^dependencies = \[(.+)\]", "pyproject.toml")))
        names = {"Eigen3": "eigen", "CLI11": "cli11", "nlohmann_json": "nlohmann", "PNG": "libpng", "SQLite3": "sqlite", "CGAL": "cgal"}
        for package in looked_for - {"Threads", "PkgConfig", "MPI"}:
            for path in ("share/packaging/spack/package.py", "share/packaging/conda/recipe.yaml"):
                self.assertIn(names.get(package, package.lower()), text(path), path)

    def test_the_paper_is_of_the_length_and_cites_what_it_lists(self):
        _, head, body = text("share/joss/paper.md").split("---\n", 2)
        self.assertTrue(250 <= len(body.split()) <= 1000, len(body.split()))
        for key in ("title", "tags", "authors", "affiliations", "date", "bibliography"):
            self.assertRegex(head, rf"(?m)^{key}:")
        for section in ("Summary", "Statement of need", "State of the field", "References"):
            self.assertRegex(body, rf"(?m)^# {section}$")
        self.assertEqual(set(re.findall(r"@(\w+)", body)), set(re.findall(r"^@\w+\{(\w+),", text("share/joss/paper.bib"), re.M)))


class Sources(unittest.TestCase):
    """What pip asks of the sources."""

    def backend(self, folder, call, path=""):
        script = f"import build_backend; print(build_backend.{call})"
        variables = os.environ | {"PYTHONPATH": str(TOP / "share/packaging"), "PYTHONDONTWRITEBYTECODE": "1", "PATH": f"{path}{os.environ['PATH']}"}
        return subprocess.run([sys.executable, "-c", script], cwd=folder, env=variables, capture_output=True, text=True)

    def test_one_line_names_the_packages_that_are_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            known = "#!/bin/sh\ncase $3 in libvtk9-dev | libopenmpi-dev) exit 1;; libpng-dev) printf 'not-installed ';; *) printf 'installed ';; esac\n"
            for name, text in (("cmake", "#!/bin/sh\necho VTK?\nexit 1\n"), ("apt-get", "#!/bin/sh\n"), ("dpkg-query", known)):
                Path(folder, name).write_text(text)
                Path(folder, name).chmod(0o755)
            done = self.backend(folder, f"build_wheel('.', {{'build-dir': '{folder}/build'}})", f"{folder}:")
        self.assertEqual(done.stderr, "graincrack: packages are missing; with root rights: apt-get install --no-install-recommends libpng-dev libvtk9-dev\n")
        self.assertNotEqual(done.returncode, 0)

    def test_a_setting_that_is_none_is_named(self):
        done = self.backend(TOP, "build_wheel('.', {'bundel': 'yes'})")
        self.assertEqual(done.stderr, "graincrack: --config-settings bundel: unknown; build-dir=FOLDER or bundle=yes fits\n")

    def test_a_build_folder_of_other_sources_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CMakeCache.txt").write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/other\n")
            done = self.backend(TOP, f"build_wheel('.', {{'build-dir': '{folder}'}})")
        self.assertEqual(done.stderr, f"graincrack: --config-settings build-dir={folder}: is configured for the sources in /other, not {TOP}; name another\n")

    def test_an_archive_has_the_sources_and_their_description(self):
        with tempfile.TemporaryDirectory() as folder:
            name = self.backend(TOP, f"build_sdist({folder!r})").stdout.strip()
            with tarfile.open(Path(folder, name)) as archive:
                top = name.removesuffix(".tar.gz")
                archive.getmember(f"{top}/pyproject.toml")
                description = archive.extractfile(f"{top}/PKG-INFO").read().decode()
        self.assertRegex(description, rf"(?s)^Metadata-Version: 2.4\nName: graincrack\nVersion: {top.partition('-')[2]}\n.*\nRequires-Dist: h5py\n")


class Crate(unittest.TestCase):
    def crate(self, *licence):
        with tempfile.TemporaryDirectory() as folder:
            results, post = Path(folder, "results"), Path(folder, "post")
            post.write_text("#!/bin/sh\necho 'graincrack-post 0.1.0 (abc)'\n")
            post.chmod(0o755)
            for name in ("fpz/page.md", "fpz/claims.tsv", "runs/a rock.5fee/one.h5", "runs/a rock.5fee/one.h5.options", "empty/.lock"):
                (results / name).parent.mkdir(parents=True, exist_ok=True)
                (results / name).write_text("x")
            command = [TOP / "share/studies/lib/crate", post, results, *licence]
            subprocess.run(command, check=True)
            made = (results / "ro-crate-metadata.json").read_text()
            subprocess.run(command, check=True)
            self.assertEqual((results / "ro-crate-metadata.json").read_text(), made)  # itself is no part of it
            self.assertEqual(list(results.glob("*.part")), [])
        content = json.loads(made)
        self.assertEqual(content["@context"], "https://w3id.org/ro/crate/1.1/context")
        self.assertEqual(len({each["@id"] for each in content["@graph"]}), len(content["@graph"]))
        return {each["@id"]: each for each in content["@graph"]}

    def references(self, value):
        for each in value if isinstance(value, list) else [value]:
            if isinstance(each, dict):
                yield each["@id"]

    def test_it_names_what_is_there_and_what_it_refers_to(self):
        graph = self.crate()
        self.assertEqual(graph["ro-crate-metadata.json"]["about"], {"@id": "./"})
        self.assertEqual(graph["ro-crate-metadata.json"]["conformsTo"], {"@id": "https://w3id.org/ro/crate/1.1"})
        for key in ("name", "description", "datePublished", "hasPart"):
            self.assertTrue(graph["./"][key])
        self.assertEqual({each for each in graph if graph[each]["@type"] == "File"}, {"fpz/page.md", "fpz/claims.tsv", "runs/a%20rock.5fee/one.h5"})
        self.assertEqual({each for each in graph if graph[each]["@type"] == "Dataset"}, {"./", "fpz/", "runs/"})
        self.assertEqual(graph["#graincrack"]["softwareVersion"], "0.1.0 (abc)")
        outside = {"https://w3id.org/ro/crate/1.1"}
        named = {each for entity in graph.values() for value in entity.values() for each in self.references(value)}
        self.assertEqual(named - set(graph) - outside, set())
        self.assertEqual(set(graph) - named, {"ro-crate-metadata.json"})

    def test_the_licence_of_results_is_their_owner_s(self):
        self.assertNotIn("license", self.crate()["./"])
        for licence in ("https://spdx.org/licenses/CC-BY-4.0", f"https://spdx.org/licenses/{LICENCE}"):
            self.assertEqual(self.crate(licence)["./"]["license"], {"@id": licence})


if __name__ == "__main__":
    unittest.main()
