extends SceneTree
# Casts rays from above onto the shape of the example, and lets its ball fall: what land_test.py compares.
#
#     godot --script res://shapes.gd --fixed-fps 60 -- SCENE PLACES.json OUT.json

func _initialize():
	var arguments := OS.get_cmdline_user_args()
	root.disable_3d = true  # nothing is drawn
	var scene: Node3D = load(arguments[0]).instantiate()
	root.add_child(scene)
	for frame in 2:
		await physics_frame
	var ball: RigidBody3D = scene.get_node("Ball")
	var heights := []
	for place in JSON.parse_string(FileAccess.get_file_as_string(arguments[1])):
		var from := Vector3(place[0], 100.0, place[1])
		var ray := PhysicsRayQueryParameters3D.create(from, from + Vector3.DOWN * 200.0)
		ray.exclude = [ball.get_rid()]
		heights.append(root.world_3d.direct_space_state.intersect_ray(ray).position.y)
	for frame in 900:
		await physics_frame
	var at := ball.position
	var found := {"heights": heights, "ball": [at.x, at.y, at.z], "speed": ball.linear_velocity.length()}
	FileAccess.open(arguments[2], FileAccess.WRITE).store_string(JSON.stringify(found, "", true, true))
	quit()
