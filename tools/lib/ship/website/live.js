// Draws the pictures of the tutorial, each by the shader beside it. One context of WebGL2 serves all, since browsers
// keep few of them.
(() => {
  "use strict";
  const drawing = document.createElement("canvas");
  const gl = drawing.getContext("webgl2");
  const library = document.getElementById("library").textContent;
  const corners = "#version 300 es\nvoid main() {\n" +
    "  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);\n}\n";

  function programOf(text) {
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, corners], [gl.FRAGMENT_SHADER, library + text]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  function drawn(figure, program, seconds) {
    const canvas = figure.querySelector("canvas");
    drawing.width = canvas.width;
    drawing.height = canvas.height;
    gl.viewport(0, 0, drawing.width, drawing.height);
    gl.useProgram(program);
    gl.uniform1f(gl.getUniformLocation(program, "time"), seconds);
    gl.uniform1f(gl.getUniformLocation(program, "size"), drawing.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    canvas.getContext("2d").drawImage(drawing, 0, 0);
    figure.dataset.drawn = "";
  }

  // Whoever wants no movement sees the first picture until the button is pressed.
  function move(figure, program) {
    const button = document.createElement("button");
    let moving = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    let seen = false;
    let seconds = 0;
    let last = 0;
    const say = () => { button.textContent = moving ? "Stop" : "Move"; };
    const step = (now) => {
      if (!moving || !seen) return;
      seconds += Math.min((now - last) / 1000, 0.1);
      last = now;
      drawn(figure, program, seconds);
      requestAnimationFrame(step);
    };
    const begin = () => { if (moving && seen) requestAnimationFrame((now) => { last = now; step(now); }); };
    button.type = "button";
    button.addEventListener("click", () => { moving = !moving; say(); begin(); });
    new IntersectionObserver(([entry]) => { seen = entry.isIntersecting; begin(); }).observe(figure);
    say();
    figure.append(button);
  }

  for (const figure of document.querySelectorAll("figure.live")) {
    try {
      if (!gl) throw new Error("this browser has no WebGL2");
      const program = programOf(figure.querySelector("script").textContent);
      drawn(figure, program, 0);
      if ("moves" in figure.dataset) move(figure, program);
    } catch (reason) {
      const text = document.createElement("p");
      text.textContent = `There is no picture here: ${reason.message}.`;
      figure.replaceChildren(text);
    }
  }
})();
