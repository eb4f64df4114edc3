#include "widgets/help/param_page.h"

#include "core/params/tree_edit_table.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/properties/param_facts.h"
#include <QCoreApplication>
#include <string_view>

namespace ramure {
namespace {

struct PageWords
{
    Q_DECLARE_TR_FUNCTIONS(ParamPage)
};

QString title()
{
    return PageWords::tr("Parameters");
}

/// Symbols of the grammar stand in these texts, which Markdown would take for its own.
QString escaped(QString text)
{
    for (const char* mark : {"\\", "[", "]", "*", "_", "`", "|", "<"})
        text.replace(QLatin1String(mark), QLatin1Char('\\') + QLatin1String(mark));
    return text;
}

QString paragraph(const ParamDef& def)
{
    QString text =
        QStringLiteral("\n**%1** `%2`  \n%3\n\n")
            .arg(escaped(coreText(def.label)), QLatin1String(def.key), escaped(coreText(def.tooltip)));
    QStringList facts;
    for (const auto& [name, value] : paramFacts(def, AngleUnit::Degrees))
        facts += QStringLiteral("*%1:* %2").arg(name, escaped(value));
    return text + facts.join(QStringLiteral(" · ")) + u'\n';
}

} // namespace

QString paramPage()
{
    QString page =
        QStringLiteral("# %1\n\n%2\n")
            .arg(title(), PageWords::tr("The key is the name in project files, and on the command line: "
                                        "`--set key=value`. Numbers outside the range are refused."));
    std::string_view group;
    for (const ParamDef& def : allParams()) {
        if (group != def.group)
            page += QStringLiteral("\n## %1\n").arg(coreText(def.group));
        group = def.group;
        page += paragraph(def);
    }
    return page;
}

std::vector<HandbookHeading> paramPageHeadings()
{
    std::vector<HandbookHeading> headings{{1, title(), QStringLiteral("parameters")}};
    std::string_view group;
    for (const ParamDef& def : allParams()) {
        if (group != def.group)
            headings.push_back({2, coreText(def.group), headingAnchor(QString::fromLatin1(def.group))});
        group = def.group;
    }
    return headings;
}

} // namespace ramure
