# The shape of the land for physics: a height at each metre, by noise that has the bits of the shader's. In
# land.gdshaderinc the formula is the same.
extends StaticBody3D

const HashNoise := preload("hn_fbm2.gd")
const SIDE := 129  # heights along each axis


func _ready() -> void:
	var heights := PackedFloat32Array()
	for z in SIDE:
		for x in SIDE:
			heights.append(height(x - 64, z - 64))
	var shape := HeightMapShape3D.new()
	shape.map_width = SIDE
	shape.map_depth = SIDE
	shape.map_data = heights
	$Shape.shape = shape


static func height(x: float, z: float) -> float:
	return 22.0 * HashNoise.fbm2(x / 32.0, z / 32.0, 6, 2.0, 0.5, 7) + 3.0 - 0.0032 * (x * x + z * z)
