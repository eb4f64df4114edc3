# The Debian package: ./dev package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ramure)
set(CPACK_PACKAGE_CONTACT "The Ramure authors <authors@ramure.org>")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${CMAKE_SOURCE_DIR}/resources/package/description)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Not linked against, but loaded: it draws the icons.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libqt6svg6)
# Qt's own dialogs in the user's language.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS qt6-translations-l10n)
# `ramure-cli render` where there is no display.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS xvfb)
include(CPack)
