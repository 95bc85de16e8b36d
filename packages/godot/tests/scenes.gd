extends SceneTree
# Shows scenes, those in 3D four seconds after their start, and writes a picture of each.
#
#     godot --script res://scenes.gd --fixed-fps 60 -- FOLDER png|jpg SCENE...

func _initialize():
	var arguments = OS.get_cmdline_user_args()
	for path in arguments.slice(2):
		var scene = load(path).instantiate()
		root.add_child(scene)
		root.disable_3d = scene is Node3D  # to draw the frames before would take minutes on a processor
		for i in 240 if root.disable_3d else 0:
			await process_frame
		root.disable_3d = false
		for i in 3:
			await process_frame
		await RenderingServer.frame_post_draw
		var out = "%s/%s.%s" % [arguments[0], path.get_file().get_basename(), arguments[1]]
		var image = root.get_texture().get_image()
		if (image.save_jpg(out, 0.85) if arguments[1] == "jpg" else image.save_png(out)) != OK:
			push_error("%s cannot be written" % out)
		root.remove_child(scene)
		scene.free()
	quit()
