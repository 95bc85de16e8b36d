"""Comments in space differ from those on the plane in these numbers, which do not follow from the dimension: costs, and
bounds, which tools/make bounds --check holds against its proofs, and ranges with the gradient of the paper, which
reaches more than 1 in space alone."""

IN_SPACE: dict[str, dict[str, str]] = {
    "cell_border2d.glsl": {
        "by y, then by x": "by z, then by y, then by x",
        "3.88e-7": "1.05e-6",
    },
    "cellular2d.glsl": {
        "1.1181": "1.2248",
        "0.43 and 0.70": "0.51 and 0.71",
        "3.53e-6": "5.93e-6",
        "6.81e-5": "6.87e-5",
        "3.18e-6": "5.49e-6",
        "9 hashes": "27 hashes",
        "9 multiplications; 2 more to spread": "27 multiplications; 3 more to spread",
        "by y, then by x": "by z, then by y, then by x",
        "3.88e-7": "1.05e-6",
    },
    "cellular_phase2d.glsl": {
        "7/8 of": "25/32 of",
        "8 multiplications": "21 multiplications",
        "1.1438": "1.208",
        "1.4367": "1.3892",
        "5.38e-6": "1.15e-5",
        "1.22e-4": "3.01e-4",
        "5.30e-6": "1.14e-5",
        "by y, then by x": "by z, then by y, then by x",
    },
    "curl_fbm2d.glsl": {
        "10 multiplications": "48 multiplications",
        "1.5 times": "1.75 times",
    },
    "fbm2d.glsl": {
        "[-1, 1], mean 0": "[-1, 1], mean 0; with HN_GRADIENT_SINE, which is not scaled, [-3/2, 3/2]",
        "creases where the noise passes 0":
            "creases where the noise passes 0; with HN_GRADIENT_SINE, which is not scaled, [0, 3/2]",
    },
    "fbm_d2d.glsl": {
        "4 multiplications": "9 multiplications",
        "2.95 times": "3.75 times",
    },
    "warp2d.glsl": {
        "8 multiplications": "18 multiplications",
    },
}
