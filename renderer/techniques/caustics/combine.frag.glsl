// What a plane's slice image shows, in the light that falls on the plane.
layout(binding = 0) uniform sampler2DArray images;
layout(binding = 1) uniform sampler2D light;
uniform int plane;

layout(location = 0) out vec4 lit;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 image = texelFetch(images, ivec3(texel, plane), 0);
  lit = vec4(image.rgb * texelFetch(light, texel, 0).rgb, image.a);
}
