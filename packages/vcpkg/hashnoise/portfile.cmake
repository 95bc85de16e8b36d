# The port of the copy of hashnoise that it lies in (docs/guide/build-systems.md).
cmake_path(SET SOURCE_PATH NORMALIZE "${CURRENT_PORT_DIR}/../../..")

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES grid HASHNOISE_GRID)
set(config_dir lib/cmake/hashnoise)
if(NOT HASHNOISE_GRID)
  set(VCPKG_BUILD_TYPE release)  # headers are the same in each
  set(config_dir share/cmake/hashnoise)
endif()
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DHASHNOISE_CONFORMANCE=OFF ${features})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH ${config_dir})
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/doc")  # LICENSE, which vcpkg has under another name
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
