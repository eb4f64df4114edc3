/// \file
/// Options, help and output that the commands of ramure-cli share.
#pragma once

#include "core/base/error.h"
#include "core/qt/base/system_path.h"
#include <QCommandLineParser>
#include <QJsonValue>
#include <QString>
#include <QStringList>
#include <optional>

namespace ramure::cli {

inline constexpr int exitGood = 0;
inline constexpr int exitCheckFailed = 1;
inline constexpr int exitBad = 2;        ///< usage or input
inline constexpr int exitRowsFailed = 3; ///< some rows of a batch
inline constexpr int exitMemory = 4;     ///< rows of a batch wanted more than they may take
inline constexpr int exitDiskFull = 5;

/// The texts of a command's help.
struct CommandText
{
    const char* name;  ///< "info"
    const char* brief; ///< in the list of commands
    const char*
        arguments; ///< "INPUT", "[INPUT]" where none is needed, or words to choose from: "presets|params"
    const char* summary; ///< one line
    const char* details; ///< paragraphs, may be empty
};

/// One command's arguments. Every command has --help and --version.
class CommandLine
{
public:
    explicit CommandLine(const CommandText& text);

    /// \param valueName "FILE", or words to choose from: "mesh|rough|skeleton"
    void add(const QStringList& names, const QString& description, const QString& valueName = {});
    void addDefault(const QStringList& names, const QString& description, const QString& valueName,
                    const QString& defaultValue);
    /// The options that every command with an INPUT has.
    void addInputOptions();
    /// --node, see keepNodes.
    void addNodeOption();

    /// An exit code where there is nothing left to do: help and version were printed.
    /// Errors: Invalid for an unknown option, or where not exactly one argument is given.
    Expected<std::optional<int>> parse(const QStringList& arguments);

    [[nodiscard]] bool has(const char* name) const { return m_parser.isSet(QString::fromLatin1(name)); }
    [[nodiscard]] QString value(const char* name) const { return m_parser.value(QString::fromLatin1(name)); }
    [[nodiscard]] QStringList values(const char* name) const
    {
        return m_parser.values(QString::fromLatin1(name));
    }
    [[nodiscard]] QStringList arguments() const { return m_parser.positionalArguments(); }
    [[nodiscard]] QString help() const;
    [[nodiscard]] const CommandText& text() const { return m_text; }
    [[nodiscard]] const QList<QCommandLineOption>& options() const { return m_options; }

private:
    CommandText m_text;
    QCommandLineParser m_parser;
    QList<QCommandLineOption> m_options;
};

/// "-o, --output FILE"
QString optionHead(const QCommandLineOption& option);
/// Fills in a text: the endings of the table of formats for {read}, {import} and {write}, and the help of
/// each written format for {formats}.
QString withFormats(const char* text);
/// Lines of at most 96 characters, each with the indentation.
QString wrapped(const QString& text, int indentation);

/// To the standard output. Error: Io.
Expected<void> print(const QString& text);
/// Indented, numbers in their shortest form.
Expected<void> printJson(const QJsonValue& value);
/// One line on the standard error, whatever the text.
void printError(const QString& text);
/// Prints something worth knowing that is no error, likewise.
void printNote(const Error& note);
QString versionText();

QString fromText(const std::string& text);

/// "a, b, c"
QString commaList(const QStringList& items);

} // namespace ramure::cli
