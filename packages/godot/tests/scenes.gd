extends SceneTree
# Shows the scenes of the example, and writes a picture of each.
#
#     godot --script res://scenes.gd -- FOLDER SCENE...

func _initialize():
	var arguments = OS.get_cmdline_user_args()
	for path in arguments.slice(1):
		var scene = load(path).instantiate()
		root.add_child(scene)
		for i in 3:
			await process_frame
		await RenderingServer.frame_post_draw
		root.get_texture().get_image().save_png(arguments[0].path_join(path.get_file().get_basename() + ".png"))
		root.remove_child(scene)
		scene.free()
	quit()
