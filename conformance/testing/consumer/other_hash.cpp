#define HN_HASH HN_HASH_JENKINS
#include <hashnoise/hashnoise.hpp>

float other_hash(float x, float y) { return hashnoise::hn_perlin(hashnoise::vec2(x, y)); }
