export default "float snoise(vec3 p) { return flour(p.x); }";
