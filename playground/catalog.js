// Made by tools/make catalog. Of a steep noise there are slopes, and a steep sum needs them.
export const kCatalog = {
  noises: {
    perlin: { dimensions: [1, 2, 3, 4], phase: true, steep: true },
    value: { dimensions: [1, 2, 3, 4], steep: true },
    value_cubic: { dimensions: [1, 2, 3] },
    simplex: { dimensions: [2, 3, 4], phase: true, steep: true },
    simplex_smooth: { dimensions: [2, 3] },
    cellular: { dimensions: [2, 3], jitter: true, metric: true },
    cellular_three: { dimensions: [2, 3], jitter: true, metric: true },
    cellular_smooth: { dimensions: [2, 3], jitter: true, range: [-0.1937, 0.875] },
    cell_border: { dimensions: [2, 3], jitter: true, range: [0, 0.844] },
    curl: { dimensions: [2, 3] },
    random: { dimensions: [1, 2, 3, 4], range: [0, 1] },
  },
  sums: {
    fbm: { dimensions: [1, 2, 3, 4] },
    turbulence: { dimensions: [1, 2, 3, 4], step: "turbulence", range: [0, 1] },
    clouds: { dimensions: [1, 2, 3, 4], mean: "density", range: [0, 1] },
    billow: { dimensions: [1, 2, 3, 4], step: "turbulence", mean: "billows" },
    ridged: { dimensions: [1, 2, 3, 4], step: "ridged", mean: "bounded", range: [0, 1] },
    hybrid: { dimensions: [1, 2, 3, 4], step: "hybrid", mean: "bounded", range: [0, 1] },
    ping_pong: { dimensions: [1, 2, 3, 4], strength: { usual: 2, most: 64 }, step: "ping_pong", mean: "bounded" },
    weighted: { dimensions: [1, 2, 3, 4], strength: { usual: 1, most: 1 }, step: "weighted", mean: "bounded" },
    eroded: { dimensions: [2, 3], strength: { usual: 1, most: 16 }, steep: true, step: "eroded" },
  },
  metrics: ["euclidean", "squared", "manhattan", "chebyshev", "hybrid"],
};
