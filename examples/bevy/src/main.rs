//! A window full of clouds, which drift. The shader is assets/shaders/clouds.wgsl; what it imports is made by
//!
//!     ../../tools/pick hn_clouds3 --language wgsl --import-path hashnoise --out assets/shaders/hashnoise.wgsl
//!
//! With the name of a PNG file, the program writes the clouds as they are at the start, and ends:
//! `cargo run -- clouds.png`.

use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_resource::AsBindGroup;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use bevy::shader::ShaderRef;
use bevy::sprite_render::{Material2d, Material2dPlugin};

#[derive(Asset, TypePath, AsBindGroup, Clone)]
struct Clouds {}

impl Material2d for Clouds {
    fn fragment_shader() -> ShaderRef {
        "shaders/clouds.wgsl".into()
    }
}

/// Bevy finds an import among the shaders that are loaded, so somebody has to keep this one.
#[derive(Resource)]
struct Library {
    noise: Handle<Shader>,
}

/// The file that the program writes, and how many frames were drawn since the shader was there.
#[derive(Resource)]
struct Picture {
    path: String,
    frames: u32,
}

fn main() {
    let mut app = App::new();
    app.add_plugins((DefaultPlugins, Material2dPlugin::<Clouds>::default())).add_systems(Startup, setup);
    if let Some(path) = std::env::args().nth(1) {
        app.insert_resource(Picture { path, frames: 0 })
            .add_systems(Startup, |mut time: ResMut<Time<Virtual>>| time.pause())
            .add_systems(Update, write_picture);
    }
    app.run();
}

fn setup(
    mut commands: Commands,
    assets: Res<AssetServer>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<Clouds>>,
) {
    commands.insert_resource(Library { noise: assets.load("shaders/hashnoise.wgsl") });
    commands.spawn(Camera2d);
    commands.spawn((
        Mesh2d(meshes.add(Rectangle::new(1280.0, 720.0))),
        MeshMaterial2d(materials.add(Clouds {})),
    ));
}

/// Bevy compiles shaders beside the frames, so the first of them are empty.
const ENOUGH_FRAMES: u32 = 120;

fn write_picture(mut commands: Commands, assets: Res<AssetServer>, library: Res<Library>, mut picture: ResMut<Picture>) {
    if !assets.is_loaded(&library.noise) {
        return;
    }
    picture.frames += 1;
    if picture.frames == ENOUGH_FRAMES {
        commands
            .spawn(Screenshot::primary_window())
            .observe(save_to_disk(picture.path.clone()))
            .observe(|_: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
                exit.write(AppExit::Success);
            });
    }
}
