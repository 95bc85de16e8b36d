// Made by tools/catalog. Of a steep noise there are slopes, and a steep sum needs them.
export const kCatalog = {
  noises: {
    value: { dimensions: [1, 2, 3, 4], steep: true },
    value_cubic: { dimensions: [1, 2, 3] },
    perlin: { dimensions: [1, 2, 3, 4], phase: true, steep: true },
    simplex: { dimensions: [2, 3, 4], phase: true, steep: true },
    simplex_smooth: { dimensions: [2, 3] },
    cellular: { dimensions: [2, 3], jitter: true, metric: true },
    cellular_three: { dimensions: [2, 3], jitter: true, metric: true },
    cellular_smooth: { dimensions: [2, 3], jitter: true },
    cell_border: { dimensions: [2, 3], jitter: true },
    curl: { dimensions: [2, 3] },
  },
  sums: {
    fbm: { dimensions: [1, 2, 3, 4] },
    turbulence: { dimensions: [1, 2, 3, 4] },
    clouds: { dimensions: [1, 2, 3, 4] },
    billow: { dimensions: [1, 2, 3, 4] },
    ridged: { dimensions: [1, 2, 3, 4] },
    ping_pong: { dimensions: [1, 2, 3, 4], strength: { usual: 2, most: 64 } },
    weighted: { dimensions: [1, 2, 3, 4], strength: { usual: 1, most: 1 } },
    eroded: { dimensions: [2, 3], strength: { usual: 1, most: 16 }, steep: true },
  },
  metrics: ["euclidean", "squared", "manhattan", "chebyshev", "hybrid"],
};
