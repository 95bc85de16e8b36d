//! A window full of clouds, which drift. The shader is assets/shaders/clouds.wgsl; what it imports is made by
//!
//!     ../../tools/pick hn_clouds3 --language wgsl --import-path hashnoise --out assets/shaders/hashnoise.wgsl

use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_resource::AsBindGroup;
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
    _noise: Handle<Shader>,
}

fn main() {
    App::new()
        .add_plugins((DefaultPlugins, Material2dPlugin::<Clouds>::default()))
        .add_systems(Startup, setup)
        .run();
}

fn setup(
    mut commands: Commands,
    assets: Res<AssetServer>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<Clouds>>,
) {
    commands.insert_resource(Library { _noise: assets.load("shaders/hashnoise.wgsl") });
    commands.spawn(Camera2d);
    commands.spawn((
        Mesh2d(meshes.add(Rectangle::new(1280.0, 720.0))),
        MeshMaterial2d(materials.add(Clouds {})),
    ));
}
