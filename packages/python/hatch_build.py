"""What packages/wheel knows and the project file cannot: the files, for which systems they are, and where the project is."""

import os
from pathlib import Path

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface


def files(folder, target):
    """Where each file of a folder goes."""
    return {str(file): str(target / file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}


class WheelHook(BuildHookInterface):
    def initialize(self, version, build_data):
        staged = Path(self.root, "staged")
        build_data["pure_python"] = False
        build_data["force_include"]["ladder_logic.py"] = "ladder_logic.py"
        build_data["tag"] = os.environ["LADDER_WHEEL_TAG"]
        # Where an environment has programs, and where its system finds manual pages and completions.
        build_data["shared_scripts"] = files(staged / "bin", Path())
        build_data["shared_data"] = files(staged / "share", Path("share"))


class UrlHook(MetadataHookInterface):
    def update(self, metadata):
        repository, site = os.environ["LADDER_REPOSITORY"], os.environ["LADDER_SITE"]
        metadata["urls"] = {
            "Homepage": site,
            "Playground": f"{site}/playground/",
            "Documentation": f"{site}/guide/getting-started.html",
            "Repository": repository,
            "Issues": f"{repository}/issues",
            "Changelog": f"{repository}/blob/main/CHANGELOG.md",
        }
