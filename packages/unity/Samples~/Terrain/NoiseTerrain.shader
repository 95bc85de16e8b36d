// Lines of height on the land of NoiseTerrain.cs, and snow above one of them.
Shader "HashNoise/NoiseTerrain" {
  SubShader {
    Pass {
      HLSLPROGRAM
      #pragma target 3.5
      #pragma vertex vert
      #pragma fragment frag
      #include "UnityCG.cginc"
      #include "Packages/com.hashnoise.noise/Shaders/HashNoiseFixed.hlsl"

      struct Point {
        float4 position : SV_POSITION;
        float2 ground : TEXCOORD0;
      };

      Point vert(float4 vertex : POSITION) {
        Point p;
        p.position = UnityObjectToClipPos(vertex);
        p.ground = vertex.xz;
        return p;
      }

      float4 frag(Point p) : SV_Target {
        float height = hn_fixed_fbm(p.ground, 6, 2.0, 0.5, 7u);
        float3 color = lerp(float3(0.16, 0.3, 0.14), float3(0.92, 0.94, 0.97), step(0.2, height));
        return float4(color * (frac(height * 16.0) < 0.1 ? 0.7 : 1.0), 1.0);
      }
      ENDHLSL
    }
  }
}
