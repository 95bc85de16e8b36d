using UnityEngine;

namespace Hashnoise {
    /// <summary>A land whose mesh has the heights that its shader draws: both compute HashNoiseFixed, so their bits are the
    /// same. Put it on an object with a material of the shader HashNoise/NoiseTerrain.</summary>
    [RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    public class NoiseTerrain : MonoBehaviour {
        const int Side = 129; // points, 16 to a cell: their positions are exact as floats
        const float Height = 2.0f;

        public static float HeightAt(float x, float z) {
            return Height * HashNoiseFixed.Fbm2(x, z, 6, 2.0f, 0.5f, 7u);
        }

        void Start() {
            var vertices = new Vector3[Side * Side];
            for (int i = 0; i < vertices.Length; i++) {
                float x = (i % Side) / 16.0f, z = (i / Side) / 16.0f;
                vertices[i] = new Vector3(x, HeightAt(x, z), z);
            }
            var triangles = new int[6 * (Side - 1) * (Side - 1)];
            for (int row = 0, at = 0; row < Side - 1; row++) {
                for (int column = 0; column < Side - 1; column++, at += 6) {
                    int corner = row * Side + column;
                    triangles[at] = triangles[at + 3] = corner;
                    triangles[at + 1] = corner + Side;
                    triangles[at + 2] = triangles[at + 4] = corner + Side + 1;
                    triangles[at + 5] = corner + 1;
                }
            }
            var mesh = new Mesh { vertices = vertices, triangles = triangles };
            mesh.RecalculateNormals();
            GetComponent<MeshFilter>().sharedMesh = mesh;
        }
    }
}
