# The settings of the library's knobs under test: a name, as in case ids and golden files, and the macros that it
# defines. The default defines nothing, so that the defaults themselves are under test. All of it as configurations.inc:
# CONFIGURATION(index, name, macros as GLSL).
set(configurations
  "fnv1 HN_HASH=HN_HASH_FNV1"
  "partial_fnv1 HN_HASH=HN_HASH_PARTIAL_FNV1"
  "jenkins HN_HASH=HN_HASH_JENKINS"
  "partial_jenkins HN_HASH=HN_HASH_PARTIAL_JENKINS"
  "murmur HN_HASH=HN_HASH_MURMUR"
  "pcg HN_HASH=HN_HASH_PCG"
  "xxhash32 HN_HASH=HN_HASH_XXHASH32"
  "lattice"
  "custom HN_HASH=HN_HASH_CUSTOM")
foreach(hash fnv1 partial_fnv1 jenkins partial_jenkins murmur lattice)
  string(TOUPPER ${hash} upper)
  list(APPEND configurations "${hash}+sine HN_HASH=HN_HASH_${upper} HN_GRADIENT=HN_GRADIENT_SINE")
endforeach()
list(APPEND configurations
  "lattice+period64 HN_PERIOD=64"
  "lattice+period48 HN_PERIOD=48"
  "lattice+period1048576 HN_PERIOD=1048576"
  "fnv1+sine+period1048576 HN_HASH=HN_HASH_FNV1 HN_GRADIENT=HN_GRADIENT_SINE HN_PERIOD=1048576")
foreach(arithmetic precise fixed)
  string(TOUPPER ${arithmetic} upper)
  list(APPEND configurations
    "lattice+${arithmetic} HN_ARITHMETIC=HN_${upper}"
    "fnv1+${arithmetic} HN_HASH=HN_HASH_FNV1 HN_ARITHMETIC=HN_${upper}"
    "lattice+sine+${arithmetic} HN_GRADIENT=HN_GRADIENT_SINE HN_ARITHMETIC=HN_${upper}"
    "lattice+period48+${arithmetic} HN_PERIOD=48 HN_ARITHMETIC=HN_${upper}")
endforeach()

set(configurations_inc "")
set(index 0)
foreach(configuration ${configurations})
  separate_arguments(macros UNIX_COMMAND "${configuration}")
  list(POP_FRONT macros name)
  list(TRANSFORM macros REPLACE "^([^=]*)=(.*)$" "#define \\1 \\2\\\\n" OUTPUT_VARIABLE glsl)
  string(REPLACE ";" "" glsl "${glsl}")
  string(APPEND configurations_inc "CONFIGURATION(${index}, \"${name}\", \"${glsl}\")\n")
  math(EXPR index "${index} + 1")
endforeach()
file(CONFIGURE OUTPUT ${rooms_directory}/generated/library/library/configurations.inc CONTENT "${configurations_inc}" @ONLY)
