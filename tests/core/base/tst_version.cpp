#include "core/base/version.h"

#include "tests/support/suite.h"
#include <fstream>
#include <sstream>
#include <string>

namespace tst_version {

/// What people read the version from says the one of the program.
class TestVersion : public QObject
{
    Q_OBJECT
private slots:
    void init() { ramure::test::failOnAnyWarning(); }

    void everyPlaceSaysIt_data()
    {
        QTest::addColumn<std::string>("file");
        QTest::addColumn<std::string>("text");
        const std::string version = RAMURE_VERSION;
        QTest::newRow("README") << std::string("README.md") << "/ramure_" + version + "_amd64.deb";
        QTest::newRow("changelog") << std::string("resources/package/changelog")
                                   << "ramure (" + version + ')';
        QTest::newRow("Python") << std::string("app/python/ramure/version.py")
                                << "__version__ = \"" + version + '"';
        QTest::newRow("AppStream") << std::string("resources/desktop/org.ramure.Ramure.metainfo.xml")
                                   << "<releases>\n    <release version=\"" + version + '"';
    }

    void everyPlaceSaysIt()
    {
        QFETCH(std::string, file);
        QFETCH(std::string, text);
        std::ostringstream read;
        read << std::ifstream(std::string(RAMURE_SOURCE_DIR "/") + file).rdbuf();
        const std::size_t at = read.str().find(text);
        QVERIFY2(at != std::string::npos, text.c_str());
        QVERIFY(file != "resources/package/changelog" || at == 0);
    }
};

RAMURE_SUITE(TestVersion)

} // namespace tst_version

#include "tst_version.moc"
