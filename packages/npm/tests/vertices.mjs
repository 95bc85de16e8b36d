// Numbers of GLSL, bit for bit.
/** In a page: the bits of a call at p for each row of three words, two of p and one more, by WebGL2's stage of vertices. */
export function evaluate(text, call, rows) {
  const gl = document.createElement("canvas").getContext("webgl2");
  const program = gl.createProgram();
  for (const [stage, source] of [[gl.VERTEX_SHADER, `#version 300 es
${text}
in highp uvec3 row;
flat out highp uint height;
void main() {
  highp vec2 p = vec2(uintBitsToFloat(row.x), uintBitsToFloat(row.y));
  height = floatBitsToUint(${call});
  gl_Position = vec4(0.0);
}`], [gl.FRAGMENT_SHADER, "#version 300 es\nvoid main() {}"]]) {
    const shader = gl.createShader(stage);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.transformFeedbackVaryings(program, ["height"], gl.SEPARATE_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Uint32Array(rows.flat()), gl.STATIC_DRAW);
  const at = gl.getAttribLocation(program, "row");
  gl.enableVertexAttribArray(at);
  gl.vertexAttribIPointer(at, 3, gl.UNSIGNED_INT, 0, 0);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, gl.createBuffer());
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 4 * rows.length, gl.STATIC_READ);
  gl.enable(gl.RASTERIZER_DISCARD);
  gl.beginTransformFeedback(gl.POINTS);
  gl.drawArrays(gl.POINTS, 0, rows.length);
  gl.endTransformFeedback();
  const words = new Uint32Array(rows.length);
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, words);
  return Array.from(words);
}
