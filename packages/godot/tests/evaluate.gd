extends SceneTree
# Draws shaders into a picture each, and writes the bytes of the pictures: what values_test.py and example_test.py
# compare.
#
#     godot --script res://evaluate.gd -- JOB.json
#
# The job is {"size": [WIDTH, HEIGHT], "shaders": [{"code": PATH, "rows": [{"out": PATH, "which": N, "inputs":
# PATH}]}]}; a code that ends in .tres is a visual shader. "which" is for a uniform, and "inputs" has the floats of a texture; a row may have neither.

func _initialize():
	var job = JSON.parse_string(FileAccess.get_file_as_string(OS.get_cmdline_user_args()[0]))
	var size = Vector2i(job.size[0], job.size[1])
	var viewport = SubViewport.new()
	viewport.size = size
	viewport.disable_3d = true
	viewport.transparent_bg = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(viewport)
	var tile = ColorRect.new()
	tile.size = size
	viewport.add_child(tile)
	for entry in job.shaders:
		var material = ShaderMaterial.new()
		if entry.code.ends_with(".tres"):
			material.shader = load(entry.code)
		else:
			material.shader = Shader.new()
			material.shader.code = FileAccess.get_file_as_string(entry.code)
		tile.material = material
		for row in entry.rows:
			if row.has("inputs"):
				var floats = FileAccess.get_file_as_bytes(row.inputs)
				var image = Image.create_from_data(size.x * 2, size.y, false, Image.FORMAT_RGBAF, floats)
				material.set_shader_parameter("inputs_of_rows", ImageTexture.create_from_image(image))
				material.set_shader_parameter("which_row", int(row.which))
			await process_frame
			await RenderingServer.frame_post_draw
			var drawn = viewport.get_texture().get_image()
			if drawn.get_format() != Image.FORMAT_RGBA8:
				drawn.convert(Image.FORMAT_RGBA8)
			var out = FileAccess.open(row.out, FileAccess.WRITE)
			out.store_buffer(drawn.get_data())
			out.close()
	quit()
