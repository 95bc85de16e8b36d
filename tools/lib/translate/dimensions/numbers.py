"""Comments in space differ from those on the plane in these numbers, which do not follow from the dimension: costs, and
errors, which tools/make bounds --check compares with the record, and ranges with the gradient of the paper, which
reaches more than 1 in space alone."""

IN_SPACE: dict[str, dict[str, str]] = {
    "cell_border2d.glsl": {
        "by y, then by x": "by z, then by y, then by x",
        "3.88e-7": "1.05e-6",
    },
    "cellular2d.glsl": {
        "1.1181": "1.2248",
        "0.43 and 0.70": "0.51 and 0.71",
        "2.08e-6": "2.36e-6",
        "6.81e-5": "6.87e-5",
        "9 hashes": "27 hashes",
        "9 multiplications; 2 more to spread": "27 multiplications; 3 more to spread",
        "by y, then by x": "by z, then by y, then by x",
        "2.98e-7": "4.76e-7",
    },
    "cellular_phase2d.glsl": {
        "7/8 of": "25/32 of",
        "8 multiplications": "21 multiplications",
        "1.1438": "1.208",
        "1.4367": "1.3892",
        "5.08e-6": "6.78e-6",
        "1.22e-4. From": "2.54e-4. From",
        "4.34e-6. HN_FIXED 1.22e-4": "7.32e-6. HN_FIXED 3.00e-4",
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
