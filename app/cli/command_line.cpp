#include "app/cli/command_line.h"
#include "core/base/file_writer.h"
#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cerrno>
#include <cstdio>

namespace ramure::cli {

QString wrapped(const QString& text, int indentation)
{
    constexpr int width = 96;
    const QString margin(indentation, QLatin1Char(' '));
    QString out;
    QString line;
    const auto flush = [&] {
        if (!line.isEmpty())
            out += margin + line + QLatin1Char('\n');
        line.clear();
    };
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (!line.isEmpty() && indentation + line.size() + 1 + word.size() > width)
            flush();
        line += (line.isEmpty() ? QString() : QStringLiteral(" ")) + word;
    }
    flush();
    return out;
}

QString withFormats(const char* text)
{
    QString written;
    for (const FileFormat* format : fileFormats())
        if (*format->help != '\0')
            written += QStringLiteral("%1.%2 (%3)")
                           .arg(QLatin1String(written.isEmpty() ? "" : " or "), QLatin1String(format->ending),
                                QLatin1String(format->help));
    return QString::fromUtf8(text)
        .replace(QLatin1String("{formats}"), written)
        .replace(QLatin1String("{read}"), fromText(endingList(FormatUse::Read)))
        .replace(QLatin1String("{import}"), fromText(endingList(FormatUse::Import)))
        .replace(QLatin1String("{write}"), fromText(endingList(FormatUse::Write)));
}

QString optionHead(const QCommandLineOption& option)
{
    QStringList names;
    for (const QString& name : option.names())
        names << (name.size() == 1 ? QLatin1Char('-') + name : QStringLiteral("--") + name);
    const QString value = option.valueName();
    return names.join(QStringLiteral(", ")) + (value.isEmpty() ? QString() : QLatin1Char(' ') + value);
}

CommandLine::CommandLine(const CommandText& text)
    : m_text(text)
{
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsCompactedShortOptions);
    add({QStringLiteral("help"), QStringLiteral("h")}, QStringLiteral("Shows this text."));
    add({QStringLiteral("version")}, QStringLiteral("Shows the version of the program."));
}

void CommandLine::add(const QStringList& names, const QString& description, const QString& valueName)
{
    addDefault(names, description, valueName, {});
}

void CommandLine::addDefault(const QStringList& names, const QString& description, const QString& valueName,
                             const QString& defaultValue)
{
    const QCommandLineOption option(names, description, valueName, defaultValue);
    m_parser.addOption(option);
    m_options.append(option);
}

void CommandLine::addNodeOption()
{
    add({QStringLiteral("node")},
        QStringLiteral("Only the node of this name of a scene and what hangs below it, even where it is "
                       "hidden; may be repeated. `info --json` lists the nodes."),
        QStringLiteral("NAME"));
}

void CommandLine::addInputOptions()
{
    add({QStringLiteral("set")},
        QStringLiteral("Sets a parameter of every tree of the INPUT; may be repeated. `ramure-cli list "
                       "params` shows the keys. In "
                       "texts, \\n is a new line and \\\\ a backslash."),
        QStringLiteral("KEY=VALUE"));
}

Expected<std::optional<int>> CommandLine::parse(const QStringList& arguments)
{
    const bool isGood = m_parser.parse(QStringList{QString()} + arguments);
    if (has("help")) {
        RAMURE_TRY(print(help()));
        return std::optional<int>(exitGood);
    }
    if (has("version")) {
        RAMURE_TRY(print(versionText()));
        return std::optional<int>(exitGood);
    }
    const std::string hint = std::string("`ramure-cli ") + m_text.name + " --help` shows what it takes";
    if (!isGood) {
        QString text = m_parser.errorText();
        if (text.endsWith(QLatin1Char('.')))
            text.chop(1);
        return fail(ErrorCode::Invalid, "%1: %2", {text.toStdString(), hint});
    }
    const auto count = m_parser.positionalArguments().size();
    if (count < 1 && *m_text.arguments != '[')
        return fail(ErrorCode::Invalid, "missing %1: %2", {m_text.arguments, hint});
    if (count > 1)
        return fail(ErrorCode::Invalid, "unexpected argument \"%1\": %2",
                    {m_parser.positionalArguments().at(1).toStdString(), hint});
    return std::optional<int>();
}

QString CommandLine::help() const
{
    QString out = QStringLiteral("Usage: ramure-cli %1 %2 [OPTIONS]\n\n%3\n")
                      .arg(QLatin1String(m_text.name), QLatin1String(m_text.arguments),
                           wrapped(QString::fromUtf8(m_text.summary), 0));
    for (const QString& paragraph : withFormats(m_text.details).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        out += paragraph.startsWith(QLatin1Char(' ')) ? paragraph + QLatin1Char('\n') : wrapped(paragraph, 0);
    out += QStringLiteral("\nOptions:\n");
    for (const QCommandLineOption& option : m_options)
        out +=
            QStringLiteral("  ") + optionHead(option) + QLatin1Char('\n') + wrapped(option.description(), 6);
    return out;
}

Expected<void> print(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    errno = 0;
    const std::size_t written =
        std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stdout);
    if (written != static_cast<std::size_t>(bytes.size()) || std::fflush(stdout) != 0)
        return fail(writeError("the standard output", errno));
    return {};
}

Expected<void> printJson(const QJsonValue& value)
{
    const QJsonDocument document =
        value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
    return print(QString::fromUtf8(document.toJson(QJsonDocument::Indented)));
}

void printError(const QString& text)
{
    const QByteArray line = ("ramure-cli: " + text.simplified() + QLatin1Char('\n')).toUtf8();
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

void printNote(const Error& note)
{
    printError(fromText(note.message()));
}

QString versionText()
{
    return QStringLiteral("ramure-cli %1\n").arg(QLatin1String(RAMURE_VERSION));
}

QString fromText(const std::string& text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString commaList(const QStringList& items)
{
    return items.join(QStringLiteral(", "));
}

} // namespace ramure::cli
