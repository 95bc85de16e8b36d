# All nodes of visual shaders have this in common; each of the other scripts here has the rest of one.
@tool
extends VisualShaderNodeCustom

const FOLDER := "res://addons/hashnoise/nodes/"
const ARITHMETICS: PackedStringArray = ["Fast", "Fixed"]

var title := ""        # its name in the menu, and of its class
var description := ""
var text := ""         # the file with its functions, which begin with the name of the file
var expression := ""   # of the function, with %s for each input
var inputs := []       # of each the name, the type, and the default; a position has none
var output := PORT_TYPE_SCALAR


func _get_name() -> String:
	return title


func _get_category() -> String:
	return "hashnoise"


func _get_description() -> String:
	return description


func _get_return_icon_type() -> PortType:
	return output


func _get_input_port_count() -> int:
	return inputs.size()


func _get_input_port_name(port: int) -> String:
	return inputs[port][0]


func _get_input_port_type(port: int) -> PortType:
	return inputs[port][1]


# The editor calls it again when the arithmetic changes; then the user's value stays.
func _get_input_port_default_value(port: int) -> Variant:
	var set_by_user = get_input_port_default_value(port)
	return inputs[port][2] if set_by_user == null else set_by_user


func _get_output_port_count() -> int:
	return 1


func _get_output_port_name(_port: int) -> String:
	return "value"


func _get_output_port_type(_port: int) -> PortType:
	return output


func _get_property_count() -> int:
	return 1


func _get_property_name(_index: int) -> String:
	return "Arithmetic"


func _get_property_default_index(_index: int) -> int:
	return 0


func _get_property_options(_index: int) -> PackedStringArray:
	return ARITHMETICS


func _get_global_code(_mode: Shader.Mode) -> String:
	return '#include "%s%s.gdshaderinc"\n' % [FOLDER, text]


func _get_code(given: Array[String], results: Array[String], mode: Shader.Mode, _type: VisualShader.Type) -> String:
	var arguments := []
	for port in inputs.size():
		arguments.append(given[port] if given[port] else _usual(port, mode))
	var arithmetic := ARITHMETICS[get_option_index(0)].to_lower()
	return "%s = %s;" % [results[0], expression.replace("hn_", "hn_%s_%s_" % [text, arithmetic]) % arguments]


## The text of an input that nothing is connected to.
func _usual(port: int, mode: Shader.Mode) -> String:
	var value = inputs[port][2]
	match inputs[port][1]:
		PORT_TYPE_SCALAR: return "%f" % value
		PORT_TYPE_SCALAR_INT: return "%d" % value
		PORT_TYPE_SCALAR_UINT: return "%du" % value
	var type := "vec2" if inputs[port][1] == PORT_TYPE_VECTOR_2D else "vec3"
	if value != null:
		return type + str(value)
	var place: String = {
		Shader.MODE_SPATIAL: "UV", Shader.MODE_CANVAS_ITEM: "UV", Shader.MODE_SKY: "SKY_COORDS",
	}.get(mode, "vec2(0.0)")
	return "%s * 8.0" % place if type == "vec2" else "vec3(%s * 8.0, 0.0)" % place
