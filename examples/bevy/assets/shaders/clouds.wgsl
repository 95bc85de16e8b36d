#import bevy_sprite::mesh2d_vertex_output::VertexOutput
#import bevy_sprite::mesh2d_view_bindings::globals
#import hashnoise::hn_clouds3

fn sky(uv: vec2f, seconds: f32) -> vec3f {
  let p = vec3f(uv * vec2f(8.0, 4.5) + vec2f(0.1 * seconds, 0.0), 0.05 * seconds);
  let thick = hn_clouds3(p, 6, 2.0, 0.5, 7u);
  return mix(mix(vec3f(0.72, 0.83, 0.93), vec3f(0.2, 0.42, 0.75), 1.0 - uv.y), vec3f(1.0), thick);
}

@fragment
fn fragment(mesh: VertexOutput) -> @location(0) vec4f {
  return vec4f(sky(mesh.uv, globals.time), 1.0);
}
