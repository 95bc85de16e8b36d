"""Blue noise: a mask of thresholds, by Ulichney's "The void-and-cluster method for dither array generation" (1993)."""

import numpy as np

from ._bake_values import Stop, component_names
from ._grids import grid

NAME = "bluenoise"
OPTIONS = ("components", "frames", "seed", "size")
_OF_FILES = ("function", "out", "format", "layout", "columns", "json", "threads")
LONGEST_SIDE, MOST_FRAMES = 512, 256
# A Gaussian with a deviation of 1.5 pixels, 2^40 exp(-d / 4.5) for the square d of a distance. Energies are sums of
# these and of 24 bits of a hash, so all of them are whole numbers, and no machine rounds one otherwise.
_FACTOR = 3439140958  # 2^32 exp(-1 / 4.5)
_WEIGHTS = np.array([(_FACTOR**d << 40) >> 32 * d for d in range(125)] + [0])
_FILLED = 1 << 50  # more than all weights together: a filled pixel is above all empty ones


def ranks(words):
    """The order in which the pixels of each frame are filled, from 0 on. `words` are whole numbers below 2^24 in the
    shape (frames, height, width).

    The energy of a pixel is the sum of the weights of filled pixels around it in its frame, and of filled pixels at its
    place in other frames (Wolfe, Morrical, Akenine-Möller and Ramamoorthi, "Spatiotemporal Blue Noise Masks", 2022).
    The frames take turns, so that each has each rank once."""
    frames, height, width = words.shape
    energies = words.astype(np.int64)
    flat = energies.reshape(frames, height * width)  # the same memory
    square = _squares(height)[:, np.newaxis] + _squares(width)
    plane = _WEIGHTS[np.minimum(square, len(_WEIGHTS) - 1)] + _FILLED * (square == 0)
    line = _WEIGHTS[np.minimum(_squares(frames), len(_WEIGHTS) - 1)]
    line[::frames] = 0  # the plane has it
    signed = {1: (plane, line), -1: (-plane, -line)}

    def change(frame, pixel, sign):
        plane, line = signed[sign]
        y, x = divmod(pixel, width)
        energies[frame] += plane[height - y:2 * height - y, width - x:2 * width - x]
        flat[:, pixel] += line[frames - frame:2 * frames - frame]
        return pixel

    def fill_void(frame):
        return change(frame, int(flat[frame].argmin()), 1)

    def clear_cluster(frame):
        return change(frame, int(flat[frame].argmax()), -1)

    # A tenth of the pixels at random, moved until none has a better place: the sum of energies falls with each move.
    first = max(height * width // 10, 1)
    for frame, pixels in enumerate(flat.argsort(axis=1, kind="stable")[:, :first].tolist()):
        for pixel in pixels:
            change(frame, pixel, 1)
    frame = still = 0
    while still < frames:
        is_still = clear_cluster(frame) == fill_void(frame)
        still, frame = (still + 1, (frame + 1) % frames) if is_still else (0, frame)
    # They have the first ranks, the last one for the pixel that is most crowded. The others follow, each at the emptiest
    # place: of more than half the pixels that is where the empty ones are most crowded, as in the paper.
    start, found = energies.copy(), np.empty_like(flat)
    for rank in reversed(range(first)):
        for frame in range(frames):
            found[frame, clear_cluster(frame)] = rank
    energies[...] = start
    for rank in range(first, height * width):
        for frame in range(frames):
            found[frame, fill_void(frame)] = rank
    return found.reshape(words.shape)


def _squares(count):
    """The squares of the distances from place 0, for the places from 0 to 2 * count - 1 of a circle of `count` places."""
    place = np.arange(2 * count) % count
    return np.minimum(place, count - place)**2


def settle(given):
    """Checks the options, and makes those of the places: a cell for each pixel, and frames as the last axis."""
    for name, value in vars(given).items():
        if value is not None and value is not False and name not in (*OPTIONS, *_OF_FILES):
            raise Stop(2, f"{NAME} has no option {name}; it has {', '.join(OPTIONS)}")
    size = given.size or (64,)
    if len(size) > 2 or max(size) > LONGEST_SIDE:
        raise Stop(2, f"--size: {NAME} takes one or two numbers of at most {LONGEST_SIDE}, as in 64 or 128x64; --frames is "
                      "for a volume")
    if (given.frames or 1) > MOST_FRAMES:
        raise Stop(2, f"--frames: {given.frames} is more than {MOST_FRAMES}")
    if (given.components or "1") not in ("1", "2", "3", "4"):
        raise Stop(2, f'--components: {NAME} takes their number, 1 to 4, and not "{given.components}"')
    given.count, given.components = int(given.components or 1), None
    given.size = (size[0], size[-1], *(given.frames,) * bool(given.frames))
    given.cells, given.tile = tuple(map(float, given.size)), True


class Mask:
    """Numbers in [0, 1), a mask for each component: the centres of as many equal steps as there are pixels in a frame."""

    def __init__(self, given):
        width, height, frames = (*given.size, 1)[:3]
        self.components = component_names(given.count)
        self.ranges = [(0, 1)] * given.count
        self.settings = {"components": given.count, "frames": frames, "seed": given.seed}
        hashes = grid("random", (width, height, frames, given.count), step=1, cell=0, seed=given.seed, arithmetic="fixed")
        words = (hashes.astype(np.float64) * 2**24).astype(np.int64)
        self._values = np.stack([(ranks(word) + 0.5) / (width * height) for word in words]).astype(np.float32)

    def __call__(self, axes, shape):
        x, y, z = (*(cells for cells, _ in axes), 0)[:3]
        return np.broadcast_to(self._values[:, z, y, x], (len(self.components), *shape))
