#include "widgets/help/handbook.h"

#include "core/params/param_def.h"
#include "widgets/help/param_page.h"
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

namespace ramure {
namespace {

struct PageName
{
    const char* id;
    bool isTask;
};
constexpr PageName pageNames[] = {
    {firstHandbookPage, false}, {"ten-oaks", true},   {"hillside", true},
    {"print-bonsai", true},     {"bend-limb", true},  {"fill-a-shape", true},
    {"blender-and-back", true}, {"oak-year", true},   {"farm", true},
    {"window", false},          {"grammar", false},   {"parameters", false},
    {"motion", false},          {"animation", false}, {"keys", false},
    {"recipe", false},          {"growth", false},    {"hand", false},
    {"transform", false},       {"arm", false},       {"files", false},
    {"command-line", false},    {"python", false},    {"performance", false},
    {"peers", false},           {"news", false},
};

QString readPage(const QString& language, const char* id)
{
    QFile file(QStringLiteral(":/handbook/%1/%2.md").arg(language, QLatin1String(id)));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

QString handbookLanguage()
{
    return QLocale().language() == QLocale::French ? QStringLiteral("fr") : QStringLiteral("en");
}

QString headingAnchor(const QString& heading)
{
    QString anchor;
    for (const QChar letter : heading.toLower()) {
        if (letter.isLetterOrNumber() || letter == u'-' || letter == u'_')
            anchor += letter;
        else if (letter == u' ')
            anchor += u'-';
    }
    return anchor;
}

std::vector<HandbookHeading> headingsOf(const QString& markdown)
{
    static const QRegularExpression heading(QStringLiteral("^(#{1,4}) (.+)$"));
    static const QRegularExpression marks(QStringLiteral("[`*]"));
    std::vector<HandbookHeading> found;
    bool isCode = false;
    for (const QString& line : markdown.split(u'\n')) {
        if (line.startsWith(QLatin1String("```")))
            isCode = !isCode;
        const auto match = heading.match(line);
        if (isCode || !match.hasMatch())
            continue;
        const QString text = match.captured(2).remove(marks);
        found.push_back({static_cast<int>(match.capturedLength(1)), text, headingAnchor(text)});
    }
    return found;
}

std::vector<HandbookPage> readHandbook()
{
    const QString language = handbookLanguage(), english = QStringLiteral("en");
    std::vector<HandbookPage> pages;
    for (const auto& [id, isTask] : pageNames) {
        HandbookPage page{QString::fromLatin1(id), {}, {}, isTask};
        if (page.id == QLatin1String("parameters")) {
            page.markdown = paramPage();
            page.headings = paramPageHeadings();
        } else {
            page.markdown = readPage(language, id);
            page.headings = headingsOf(page.markdown);
            const auto names = headingsOf(readPage(english, id));
            for (std::size_t i = 0; i < std::min(names.size(), page.headings.size()); ++i)
                page.headings[i].anchor = names[i].anchor;
        }
        pages.push_back(std::move(page));
    }
    return pages;
}

} // namespace ramure
