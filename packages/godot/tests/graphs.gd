extends SceneTree
# Makes a visual shader of each node, and saves it: what nodes_test.py draws.
#
#     godot --script res://graphs.gd -- JOB.json
#
# The job is [{"node": PATH, "arithmetic": N, "inputs": {NAME: [NUMBER...]}, "out": PATH}]. Without "inputs" nothing is
# set or connected; with them the position is the texture coordinates times 8. Colours are 0.5 + 0.5 * value.

func _init():
	for entry in JSON.parse_string(FileAccess.get_file_as_string(OS.get_cmdline_user_args()[0])):
		var graph := VisualShader.new()
		graph.set_mode(Shader.MODE_CANVAS_ITEM)
		var node: VisualShaderNodeCustom = load(entry.node).new()
		node.set("properties", "0,%d" % entry.arithmetic)
		var colour := VisualShaderNodeMultiplyAdd.new()
		colour.op_type = VisualShaderNodeMultiplyAdd.OP_TYPE_VECTOR_3D
		colour.set_input_port_default_value(1, Vector3(0.5, 0.5, 0.5))
		colour.set_input_port_default_value(2, Vector3(0.5, 0.5, 0.5))
		add(graph, [node, colour])
		connect_ports(graph, [[2, 0, 3], [3, 0, 0]])
		if entry.has("inputs"):
			var place := VisualShaderNodeInput.new()
			place.input_name = "uv"
			var scaled := VisualShaderNodeVectorOp.new()
			scaled.op_type = VisualShaderNodeVectorOp.OP_TYPE_VECTOR_2D
			scaled.operator = VisualShaderNodeVectorOp.OP_MUL
			scaled.set_input_port_default_value(1, Vector2(8.0, 8.0))
			add(graph, [place, scaled])
			connect_ports(graph, [[4, 0, 5], [5, 0, 2]])
			for port in node._get_input_port_count():
				var given = entry.inputs.get(node._get_input_port_name(port))
				if given:
					node.set_input_port_default_value(port, value(node._get_input_port_type(port), given))
		if ResourceSaver.save(graph, entry.out) != OK:
			push_error("%s cannot be saved" % entry.out)
	quit()

func add(graph: VisualShader, nodes: Array) -> void:
	for node in nodes:
		graph.add_node(VisualShader.TYPE_FRAGMENT, node, Vector2(), graph.get_valid_node_id(VisualShader.TYPE_FRAGMENT))

func connect_ports(graph: VisualShader, links: Array) -> void:
	for link in links:  # a node, its output, and the node of the first input
		if graph.connect_nodes(VisualShader.TYPE_FRAGMENT, link[0], link[1], link[2], 0) != OK:
			push_error("the ports of %s cannot be connected" % [link])

func value(type: int, given: Array):
	match type:
		VisualShaderNode.PORT_TYPE_SCALAR: return given[0]
		VisualShaderNode.PORT_TYPE_VECTOR_2D: return Vector2(given[0], given[1])
		VisualShaderNode.PORT_TYPE_VECTOR_3D: return Vector3(given[0], given[1], given[2])
	return int(given[0])
