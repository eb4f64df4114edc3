#include "core/base/error.h"
#include "tests/support/suite.h"

namespace tst_error {

using namespace ramure;

class TestError : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void missingArgumentIsEmpty()
    {
        Error error;
        error.text = "%1 of %2 at 100%";
        error.args = {"one"};
        QCOMPARE(error.message(), std::string("one of  at 100%"));
    }
    void placeComesFirst()
    {
        Error error;
        error.text = "bad %1";
        error.args = {"x"};
        error.file = "a.ramure";
        error.line = 3;
        error.column = 7;
        error.path = "nodes[0]";
        QCOMPARE(error.message(), std::string("a.ramure:3:7: nodes[0]: bad x"));
        QCOMPARE(error.plain(), std::string("bad x"));
    }
};

RAMURE_SUITE(TestError)

} // namespace tst_error

#include "tst_error.moc"
