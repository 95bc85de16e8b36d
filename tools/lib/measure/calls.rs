//! Nanoseconds per point of hashnoise's crate and of others: "noise,package,nanoseconds in each round". All are called in
//! turns. Each call fills rows of points, as whoever draws a picture or makes land does. Usage: calls ROUNDS
use bevy_math::{Vec2, Vec3};
use libnoise::Generator;
use noise::{MultiFractal, NoiseFn};
use noiz::{
    cell_noise::{
        BlendCellGradients, MixCellGradients, MixCellValues, PerCellPointDistances, QuickGradients, SimplecticBlend,
        WorleyLeastDistance,
    },
    cells::{OrthoGrid, SimplexGrid, Voronoi},
    curves::Smoothstep,
    layering::{FractalLayers, LayeredNoise, Normed, Octave, Persistence},
    lengths::EuclideanLength,
    rng::{Random, UNorm},
    Noise, SampleableFor,
};
use std::{hint::black_box, time::Instant};

const SEED: u32 = 7;
const OCTAVES: usize = 6;
const PLANE: usize = 128; // points along a side: less than a slice of time that a scheduler gives
const SPACE: usize = 24;
const STEP: f32 = 1.0 / 32.0; // cells

type Call = Box<dyn Fn()>;

fn plane<T: Copy + Default + 'static>(one: impl Fn(f32, f32) -> T + 'static) -> (usize, Call) {
    (PLANE * PLANE, Box::new(move || {
        let mut row = [T::default(); PLANE];
        for y in 0..PLANE {
            for (x, value) in row.iter_mut().enumerate() {
                *value = one(x as f32 * STEP, y as f32 * STEP);
            }
            black_box(&mut row);
        }
    }))
}

fn space<T: Copy + Default + 'static>(one: impl Fn(f32, f32, f32) -> T + 'static) -> (usize, Call) {
    (SPACE * SPACE * SPACE, Box::new(move || {
        let mut row = [T::default(); SPACE];
        for z in 0..SPACE {
            for y in 0..SPACE {
                for (x, value) in row.iter_mut().enumerate() {
                    *value = one(x as f32 * STEP, y as f32 * STEP, z as f32 * STEP);
                }
                black_box(&mut row);
            }
        }
    }))
}

fn noiz2(noise: impl SampleableFor<Vec2, f32> + 'static) -> (usize, Call) {
    plane(move |x, y| noise.sample(Vec2::new(x, y)))
}

fn noiz3(noise: impl SampleableFor<Vec3, f32> + 'static) -> (usize, Call) {
    space(move |x, y, z| noise.sample(Vec3::new(x, y, z)))
}

fn lite(kind: fastnoise_lite::NoiseType, octaves: usize) -> fastnoise_lite::FastNoiseLite {
    let mut noise = fastnoise_lite::FastNoiseLite::with_seed(SEED as i32);
    noise.set_noise_type(Some(kind));
    noise.set_frequency(Some(1.0));
    if octaves > 1 {
        noise.set_fractal_type(Some(fastnoise_lite::FractalType::FBm));
        noise.set_fractal_octaves(Some(octaves as i32));
    }
    noise
}

fn lite2(kind: fastnoise_lite::NoiseType, octaves: usize) -> (usize, Call) {
    let noise = lite(kind, octaves);
    plane(move |x, y| noise.get_noise_2d(x, y))
}

fn lite3(kind: fastnoise_lite::NoiseType) -> (usize, Call) {
    let noise = lite(kind, 1);
    space(move |x, y, z| noise.get_noise_3d(x, y, z))
}

fn noise2(noise: impl NoiseFn<f64, 2> + 'static) -> (usize, Call) {
    plane(move |x, y| noise.get([x as f64, y as f64]))
}

fn noise3(noise: impl NoiseFn<f64, 3> + 'static) -> (usize, Call) {
    space(move |x, y, z| noise.get([x as f64, y as f64, z as f64]))
}

fn libnoise2(noise: impl Generator<2> + 'static) -> (usize, Call) {
    plane(move |x, y| noise.sample([x as f64, y as f64]))
}

fn libnoise3(noise: impl Generator<3> + 'static) -> (usize, Call) {
    space(move |x, y, z| noise.sample([x as f64, y as f64, z as f64]))
}

fn calls() -> Vec<(&'static str, &'static str, (usize, Call))> {
    use fastnoise_lite::NoiseType;
    use hashnoise::{fast, fixed};
    use libnoise::Source;
    type Perlin = MixCellGradients<OrthoGrid, Smoothstep, QuickGradients>;
    type Simplex = BlendCellGradients<SimplexGrid, SimplecticBlend, QuickGradients>;
    type Worley = PerCellPointDistances<Voronoi, EuclideanLength, WorleyLeastDistance>;
    let layered = Noise::from(LayeredNoise::new(
        Normed::<f32>::default(),
        Persistence(0.5),
        FractalLayers { layer: Octave::<Perlin>::default(), lacunarity: 2.0, amount: OCTAVES as u32 },
    ));
    let octaves = OCTAVES as i32;
    vec![
        ("Perlin 2D", "hashnoise", plane(|x, y| fast::perlin2(x, y, SEED))),
        ("Perlin 2D", "hashnoise fixed", plane(|x, y| fixed::perlin2(x, y, SEED))),
        ("Perlin 2D", "noiz", noiz2(Noise::<Perlin>::default())),
        ("Perlin 2D", "fastnoise-lite", lite2(NoiseType::Perlin, 1)),
        ("Perlin 2D", "libnoise", libnoise2(Source::perlin(SEED as u64))),
        ("Perlin 2D", "noise", noise2(noise::Perlin::new(SEED))),
        ("Perlin 3D", "hashnoise", space(|x, y, z| fast::perlin3(x, y, z, SEED))),
        ("Perlin 3D", "hashnoise fixed", space(|x, y, z| fixed::perlin3(x, y, z, SEED))),
        ("Perlin 3D", "noiz", noiz3(Noise::<Perlin>::default())),
        ("Perlin 3D", "fastnoise-lite", lite3(NoiseType::Perlin)),
        ("Perlin 3D", "libnoise", libnoise3(Source::perlin(SEED as u64))),
        ("Perlin 3D", "noise", noise3(noise::Perlin::new(SEED))),
        ("value 2D", "hashnoise", plane(|x, y| fast::value2(x, y, SEED))),
        ("value 2D", "hashnoise fixed", plane(|x, y| fixed::value2(x, y, SEED))),
        ("value 2D", "noiz", noiz2(Noise::<MixCellValues<OrthoGrid, Smoothstep, Random<UNorm, f32>>>::default())),
        ("value 2D", "fastnoise-lite", lite2(NoiseType::Value, 1)),
        ("value 2D", "libnoise", libnoise2(Source::value(SEED as u64))),
        ("value 2D", "noise", noise2(noise::Value::new(SEED))),
        ("simplex 2D", "hashnoise", plane(|x, y| fast::simplex2(x, y, SEED))),
        ("simplex 2D", "hashnoise fixed", plane(|x, y| fixed::simplex2(x, y, SEED))),
        ("simplex 2D", "noiz", noiz2(Noise::<Simplex>::default())),
        ("simplex 2D", "fastnoise-lite", lite2(NoiseType::OpenSimplex2, 1)),
        ("simplex 2D", "libnoise", libnoise2(Source::simplex(SEED as u64))),
        ("simplex 2D", "noise", noise2(noise::Simplex::new(SEED))),
        ("simplex 3D", "hashnoise", space(|x, y, z| fast::simplex3(x, y, z, SEED))),
        ("simplex 3D", "hashnoise fixed", space(|x, y, z| fixed::simplex3(x, y, z, SEED))),
        ("simplex 3D", "noiz", noiz3(Noise::<Simplex>::default())),
        ("simplex 3D", "fastnoise-lite", lite3(NoiseType::OpenSimplex2)),
        ("simplex 3D", "libnoise", libnoise3(Source::simplex(SEED as u64))),
        ("simplex 3D", "noise", noise3(noise::Simplex::new(SEED))),
        ("cellular 2D", "hashnoise", plane(|x, y| fast::cellular2(x, y, SEED))),
        ("cellular 2D", "hashnoise fixed", plane(|x, y| fixed::cellular2(x, y, SEED))),
        ("cellular 2D", "noiz", noiz2(Noise::<Worley>::default())),
        ("cellular 2D", "fastnoise-lite", lite2(NoiseType::Cellular, 1)),
        ("cellular 2D", "libnoise", libnoise2(Source::worley(SEED as u64))),
        ("cellular 2D", "noise", noise2(noise::Worley::new(SEED))),
        ("six octaves 2D", "hashnoise", plane(move |x, y| fast::fbm2(x, y, octaves, 2.0, 0.5, SEED))),
        ("six octaves 2D", "hashnoise fixed", plane(move |x, y| fixed::fbm2(x, y, octaves, 2.0, 0.5, SEED))),
        ("six octaves 2D", "noiz", noiz2(layered)),
        ("six octaves 2D", "fastnoise-lite", lite2(NoiseType::Perlin, OCTAVES)),
        ("six octaves 2D", "libnoise", libnoise2(Source::perlin(SEED as u64).fbm(OCTAVES as u32, 1.0, 2.0, 0.5))),
        ("six octaves 2D", "noise", noise2(noise::Fbm::<noise::Perlin>::new(SEED).set_octaves(OCTAVES).set_frequency(1.0))),
    ]
}

fn main() {
    let rounds: usize = std::env::args().nth(1).and_then(|text| text.parse().ok()).expect("the number of rounds");
    let calls = calls();
    let mut seconds = vec![Vec::new(); calls.len()];
    for round in 0..rounds + 1 {
        for ((_, _, (points, call)), times) in calls.iter().zip(&mut seconds) {
            let start = Instant::now();
            call();
            if round > 0 {
                // what is loaded at first is not measured
                times.push(format!("{:.4}", start.elapsed().as_secs_f64() * 1e9 / *points as f64));
            }
        }
    }
    for ((noise, package, _), times) in calls.iter().zip(&seconds) {
        println!("{noise},{package},{}", times.join(","));
    }
}
