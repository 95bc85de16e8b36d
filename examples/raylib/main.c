// Islands that a shader draws, in raylib. Drag them with the mouse; the space bar makes others.
#include <raylib.h>
#include <stdio.h>
#include <string.h>

// OpenGL has no #include, so the text of the library is put between the #version line and the text of a shader.
static Shader load_shader(const char *library_path, const char *path) {
  const char *version = "#version 330\n";
  char *library = LoadFileText(library_path);
  char *shader = LoadFileText(path);
  size_t size = strlen(version) + strlen(library) + strlen(shader) + 1;
  char *text = MemAlloc((unsigned)size);
  snprintf(text, size, "%s%s%s", version, library, shader);
  Shader loaded = LoadShaderFromMemory(NULL, text);
  MemFree(text);
  UnloadFileText(shader);
  UnloadFileText(library);
  return loaded;
}

int main(void) {
  InitWindow(640, 480, "hashnoise");
  SetTargetFPS(60);
  ChangeDirectory(GetApplicationDirectory());
  Shader noise = load_shader("fbm_d2d.single.glsl", "noise.fs");
  Vector2 corner = {0.0f, 0.0f};
  int seed = 1;
  while (!WindowShouldClose()) {
    if (IsMouseButtonDown(MOUSE_BUTTON_LEFT)) {
      corner.x -= GetMouseDelta().x;
      corner.y += GetMouseDelta().y;  // in shaders of OpenGL y goes up
    }
    if (IsKeyPressed(KEY_SPACE)) seed++;
    SetShaderValue(noise, GetShaderLocation(noise, "corner"), &corner, SHADER_UNIFORM_VEC2);
    SetShaderValue(noise, GetShaderLocation(noise, "seed"), &seed, SHADER_UNIFORM_INT);
    BeginDrawing();
    BeginShaderMode(noise);
    DrawRectangle(0, 0, GetScreenWidth(), GetScreenHeight(), WHITE);
    EndShaderMode();
    EndDrawing();
  }
  UnloadShader(noise);
  CloseWindow();
  return 0;
}
