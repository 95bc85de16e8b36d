extends SceneTree
# Compiles page.glsl, runs golden.glsl on the floats of the file words, and writes its 64 x 64 floats to the file
# heights. example_test.py compares them.

func _init():
	var device = RenderingServer.create_local_rendering_device()
	var failed = load("res://page.glsl").get_spirv().compile_error_compute
	if failed != "":
		push_error(failed)
	else:
		print("page.glsl compiles")
	var shader = device.shader_create_from_spirv(load("res://golden.glsl").get_spirv())
	var heights = device.storage_buffer_create(4 * 64 * 64)
	var words = FileAccess.get_file_as_bytes("res://words")
	var uniforms = []
	for buffer in [heights, device.storage_buffer_create(words.size(), words)]:
		var uniform = RDUniform.new()
		uniform.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
		uniform.binding = uniforms.size()
		uniform.add_id(buffer)
		uniforms.append(uniform)
	var list = device.compute_list_begin()
	device.compute_list_bind_compute_pipeline(list, device.compute_pipeline_create(shader))
	device.compute_list_bind_uniform_set(list, device.uniform_set_create(uniforms, shader, 0), 0)
	device.compute_list_dispatch(list, 8, 8, 1)
	device.compute_list_end()
	device.submit()
	device.sync()
	var out = FileAccess.open("res://heights", FileAccess.WRITE)
	out.store_buffer(device.buffer_get_data(heights))
	out.close()
	device.free()
	quit()
