"""Copies of other libraries on this machine, which options name."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from measure.peers.table import Peer


def add_options(parser: argparse.ArgumentParser, peers: Sequence[Peer]) -> None:
    for peer in peers:
        parser.add_argument(f"--{peer.option}", type=Path, metavar="PATH", help=f"your copy of it: {peer.what}")


def given(options: argparse.Namespace, peers: Sequence[Peer]) -> dict[str, Path]:
    """Where those of the peers are that options name. A path that leads nowhere is a ValueError."""
    paths = {peer.option: getattr(options, peer.option.replace("-", "_")) for peer in peers}
    for option, path in paths.items():
        if path is not None and not path.exists():
            raise ValueError(f"--{option}: there is no {path}")
    return {option: path for option, path in paths.items() if path is not None}


def some_given(parser: argparse.ArgumentParser, options: argparse.Namespace, peers: Sequence[Peer]) -> dict[str, Path]:
    """The same, where one at least is wanted."""
    try:
        paths = given(options, peers)
    except ValueError as error:
        parser.error(str(error))
    if not paths:
        parser.error("name at least one peer, for example --webgl-noise DIR")
    return paths
