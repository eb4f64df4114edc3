#include "app/cli/batch/job_script.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

namespace ramure::cli {

namespace {

QString words(const QStringList& list)
{
    QStringList out;
    for (const QString& word : list)
        out << shellWord(word);
    return out.join(QLatin1Char(' '));
}

/// For a shell in the folder of the trees. A part that was stopped has a manifest too, with fewer rows.
QString mergeScript(const JobRequest& request)
{
    return QStringLiteral(
               "export LC_ALL=C\n"
               "cat manifest-*-of-%1.jsonl >manifest.jsonl.part\n"
               "found=$(wc -l <manifest.jsonl.part)\n"
               "if [ \"$found\" -ne %2 ]; then\n"
               "    echo \"$found of %2 rows are there: start the job again, it does the others\" >&2\n"
               "    rm manifest.jsonl.part\n"
               "    exit 1\n"
               "fi\n"
               "mv manifest.jsonl.part manifest.jsonl\n"
               "if grep -q '\"error\":{' manifest.jsonl; then\n"
               "    echo \"$(grep -c '\"error\":{' manifest.jsonl) of %2 rows failed: manifest.jsonl says "
               "why\" >&2\n"
               "    exit 3\n"
               "fi\n")
        .arg(request.shards)
        .arg(request.rows);
}

QByteArray slurm(const JobRequest& request)
{
    QString text =
        QStringLiteral("#!/bin/bash\n"
                       "# %1 rows in %2 tasks: start it with `bash job.sbatch`. Started again, it does what "
                       "is missing.\n"
                       "#SBATCH --job-name=ramure\n"
                       "#SBATCH --cpus-per-task=%3\n"
                       "#SBATCH --requeue\n"
                       "#SBATCH --open-mode=append\n"
                       "#SBATCH --output=slurm-%A.out\n"
                       "#SBATCH --signal=B:TERM@10\n")
            .arg(request.rows)
            .arg(request.shards)
            .arg(request.processes);
    if (request.memoryBytes > 0) { // and what the program itself takes
        const std::size_t mebibytes = (request.memoryBytes >> 20) * std::size_t(request.processes) + 256;
        text += QStringLiteral("#SBATCH --mem=%1M\n").arg(mebibytes);
    }
    text += QStringLiteral(
                "set -eu\n"
                "if [ -z \"${SLURM_JOB_ID:-}\" ]; then\n"
                "    cd \"$(dirname \"$0\")\"\n"
                "    array=$(sbatch --parsable --array=1-%1 job.sbatch)\n"
                "    sbatch --parsable --dependency=\"afterany:$array\" job.sbatch merge\n"
                "    exit\n"
                "fi\n"
                "if [ \"${1:-}\" != merge ]; then\n"
                "    exec \"${RAMURE_CLI:-ramure-cli}\" batch %2 -o . --shard \"$SLURM_ARRAY_TASK_ID/%1\" "
                "--resume %3\n"
                "fi\n")
                .arg(QString::number(request.shards), shellWord(request.table), words(request.options));
    return (text + mergeScript(request)).toUtf8();
}

QByteArray makefile(const JobRequest& request)
{
    // A recipe is lines of a shell, with $$ for a $.
    const auto recipe = [](QString text) { return text.replace(QLatin1Char('$'), QStringLiteral("$$")); };
    QStringList merge = recipe(mergeScript(request)).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    merge.replaceInStrings(QRegularExpression(QStringLiteral("^")), QStringLiteral("\t"));
    const QString text =
        QStringLiteral(
            "# %1 rows in %2 parts: `make -j 8`. Started again, it does what is missing; `make -B` also "
            "tries again what failed.\n"
            "RAMURE_CLI ?= ramure-cli\n"
            ".ONESHELL:\n"
            "SHELL := /bin/bash\n"
            ".SHELLFLAGS := -euc\n"
            "parts := $(addprefix .part-,$(shell seq 1 %2))\n"
            ".PHONY: all\n"
            "all: $(parts)\n"
            "%3\n"
            "# Rows that failed are the manifest's: the others go on.\n"
            ".part-%:\n"
            "\t@\"$(RAMURE_CLI)\" batch %4 -o . --shard $*/%2 --resume %5 || [[ $$? =~ ^(1|3|4)$$ ]]\n"
            "\ttouch $@\n")
            .arg(QString::number(request.rows), QString::number(request.shards),
                 merge
                     .replaceInStrings(QRegularExpression(QStringLiteral("^\texport")),
                                       QStringLiteral("\t@export"))
                     .join(QLatin1Char('\n')),
                 recipe(shellWord(request.table)), recipe(words(request.options)));
    return text.toUtf8();
}

QByteArray openJd(const JobRequest& request)
{
    const auto path = [](const char* name, const QString& object, const QString& flow, const QString& usual) {
        return QJsonObject{{QStringLiteral("name"), QLatin1String(name)},
                           {QStringLiteral("type"), QStringLiteral("PATH")},
                           {QStringLiteral("objectType"), object},
                           {QStringLiteral("dataFlow"), flow},
                           {QStringLiteral("default"), usual}};
    };
    const auto run = [](const QString& command, const QStringList& args) {
        return QJsonObject{{QStringLiteral("onRun"),
                            QJsonObject{{QStringLiteral("command"), command},
                                        {QStringLiteral("args"), QJsonArray::fromStringList(args)}}}};
    };
    const QStringList batch =
        QStringList{QStringLiteral("batch"),    QStringLiteral("{{Param.Table}}"),
                    QStringLiteral("-o"),       QStringLiteral("{{Param.Folder}}"),
                    QStringLiteral("--shard"),  QStringLiteral("{{Task.Param.Shard}}/%1").arg(request.shards),
                    QStringLiteral("--resume"), QStringLiteral("--progress"),
                    QStringLiteral("openjd")} +
        request.options;
    const QJsonObject shard{{QStringLiteral("name"), QStringLiteral("Shard")},
                            {QStringLiteral("type"), QStringLiteral("INT")},
                            {QStringLiteral("range"), QStringLiteral("1-%1").arg(request.shards)}};
    const QJsonObject trees{
        {QStringLiteral("name"), QStringLiteral("Trees")},
        {QStringLiteral("parameterSpace"),
         QJsonObject{{QStringLiteral("taskParameterDefinitions"), QJsonArray{shard}}}},
        {QStringLiteral("script"),
         QJsonObject{{QStringLiteral("actions"), run(QStringLiteral("{{Param.Program}}"), batch)}}}};
    const QJsonObject file{
        {QStringLiteral("name"), QStringLiteral("Merge")},
        {QStringLiteral("type"), QStringLiteral("TEXT")},
        {QStringLiteral("data"), QStringLiteral("set -eu\ncd \"$1\"\n") + mergeScript(request)}};
    const QJsonObject merge{
        {QStringLiteral("name"), QStringLiteral("Merge")},
        {QStringLiteral("dependencies"),
         QJsonArray{QJsonObject{{QStringLiteral("dependsOn"), QStringLiteral("Trees")}}}},
        {QStringLiteral("script"),
         QJsonObject{{QStringLiteral("embeddedFiles"), QJsonArray{file}},
                     {QStringLiteral("actions"),
                      run(QStringLiteral("bash"),
                          {QStringLiteral("{{Task.File.Merge}}"), QStringLiteral("{{Param.Folder}}")})}}}};
    const QJsonObject program{{QStringLiteral("name"), QStringLiteral("Program")},
                              {QStringLiteral("type"), QStringLiteral("STRING")},
                              {QStringLiteral("default"), QStringLiteral("ramure-cli")}};
    const QJsonObject job{
        {QStringLiteral("specificationVersion"), QStringLiteral("jobtemplate-2023-09")},
        {QStringLiteral("name"), QStringLiteral("Ramure")},
        {QStringLiteral("parameterDefinitions"),
         QJsonArray{
             program, path("Table", QStringLiteral("FILE"), QStringLiteral("IN"), request.table),
             path("Folder", QStringLiteral("DIRECTORY"), QStringLiteral("INOUT"), QStringLiteral("."))}},
        {QStringLiteral("steps"), QJsonArray{trees, merge}}};
    return QJsonDocument(job).toJson();
}

/// A value of JavaScript.
QString json(const QJsonArray& list)
{
    return QString::fromUtf8(QJsonDocument(list).toJson(QJsonDocument::Compact));
}

QByteArray flamenco(const JobRequest& request)
{
    return QStringLiteral(
               "// %1 rows. Beside Flamenco's other job types: scripts/ramure.js. The paths are those of its "
               "workers.\n"
               "const JOB_TYPE = {\n"
               "    label: \"Ramure\",\n"
               "    settings: [\n"
               "        { key: \"program\", type: \"string\", required: true, default: \"ramure-cli\" },\n"
               "        { key: \"folder\", type: \"string\", subtype: \"dir_path\", required: true,\n"
               "            description: \"Where the trees go\" },\n"
               "        { key: \"table\", type: \"string\", required: true, default: %2[0],\n"
               "            description: \"From the folder of the trees\" },\n"
               "    ],\n"
               "};\n"
               "const shards = %3;\n"
               "const options = %4;\n"
               "const mergeScript = %5[0];\n"
               "\n"
               "function compileJob(job) {\n"
               "    const settings = job.settings;\n"
               "    const table = /^([/\\\\]|[A-Za-z]:)/.test(settings.table) ? settings.table\n"
               "        : settings.folder + \"/\" + settings.table;\n"
               "    const merge = author.Task(\"merge\", \"misc\");\n"
               "    merge.addCommand(author.Command(\"exec\", {\n"
               "        exe: \"bash\",\n"
               "        args: [\"-euc\", 'cd \"$1\"\\n' + mergeScript, \"merge\", settings.folder],\n"
               "    }));\n"
               "    for (let shard = 1; shard <= shards; shard++) {\n"
               "        const task = author.Task(\"trees-\" + shard, \"misc\");\n"
               "        task.addCommand(author.Command(\"exec\", {\n"
               "            exe: settings.program,\n"
               "            args: [\"batch\", table, \"-o\", settings.folder, \"--shard\", shard + \"/\" + "
               "shards, "
               "\"--resume\"]\n"
               "                .concat(options),\n"
               "        }));\n"
               "        merge.addDependency(task);\n"
               "        job.addTask(task);\n"
               "    }\n"
               "    job.addTask(merge);\n"
               "}\n")
        .arg(QString::number(request.rows), json({request.table}), QString::number(request.shards),
             json(QJsonArray::fromStringList(request.options)), json({mergeScript(request)}))
        .toUtf8();
}

} // namespace

const JobKind jobKinds[4] = {
    {"slurm", "job.sbatch",
     "An array job of Slurm, and one that puts the manifests together: `bash job.sbatch`.", &slurm},
    {"openjd", "job.openjd.json",
     "A template of Open Job Description 2023-09, which AWS Deadline Cloud reads.", &openJd},
    {"flamenco", "job.flamenco.js", "A job type for Flamenco 3, Blender's farm.", &flamenco},
    {"make", "Makefile", "A Makefile for one machine, or for a make that knows several: `make -j 8`.",
     &makefile},
};

QString shellWord(const QString& text)
{
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./=:,+-]+$"));
    if (plain.match(text).hasMatch())
        return text;
    QString quoted = text;
    return QLatin1Char('\'') + quoted.replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

} // namespace ramure::cli
