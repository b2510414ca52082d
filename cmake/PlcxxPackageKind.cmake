# Included by cpack for each kind of package: an archive is unpacked anywhere, the others belong below /usr.
if(CPACK_GENERATOR STREQUAL "TGZ")
  set(CPACK_PACKAGING_INSTALL_PREFIX "/")
endif()
