#include "app/cli/batch/batch_options.h"
#include "app/cli/batch/batch_row.h"
#include "app/cli/batch/sheet_page.h"
#include "app/cli/commands/commands.h"
#include "app/cli/painter.h"
#include "core/base/file_writer.h"
#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>

namespace ramure::cli {

namespace {

constexpr CommandText sheetText = {
    "sheet", "makes a contact sheet of a batch", "MANIFEST.jsonl",
    "Makes one page of HTML with a picture and the figures of each row of a manifest.",
    "Rows stand out, with what is unlike them in a frame of another colour, where a figure is far from those "
    "of the other rows of the same input; they can be filtered and sorted. A row that has a picture among "
    "its "
    "files, beside the manifest, shows that; others are grown again and drawn. The page needs no other file, "
    "and the same manifest gives the same page."};

constexpr int usualSide = 160, leastSide = 32, mostSide = 1024;
constexpr int pixelsATriangle = 8; ///< of a tree that is grown to be drawn
constexpr int jpegQuality = 85;    ///< of JPEG, in percent

/// What draws, in a process of the pool.
class Drawer
{
public:
    Drawer(QString trees, QString inputs, int side)
        : m_trees(std::move(trees))
        , m_inputs(std::move(inputs))
        , m_side(side)
    {
    }

    /// A JPEG file; empty where there is nothing to be seen.
    QByteArray draw(const QJsonObject& line)
    {
        QImage image = fromFiles(line);
        if (image.isNull())
            image = grown(line);
        if (image.isNull())
            return {};
        QBuffer bytes;
        bytes.open(QIODevice::WriteOnly);
        image.convertToFormat(QImage::Format_RGB32).save(&bytes, "JPEG", jpegQuality);
        return bytes.data();
    }

private:
    /// Pictures of maps stand in folders of their own: one beside the meshes is of the tree.
    [[nodiscard]] QImage fromFiles(const QJsonObject& line) const
    {
        const QJsonArray files = line.value(QStringLiteral("files")).toArray();
        std::map<QString, int> shares; // how many pictures there are in each folder
        QString found;
        for (const QJsonValue file : files) {
            const QString name = file.toObject().value(QStringLiteral("name")).toString();
            if (!name.endsWith(QLatin1String(".png")))
                continue;
            const QString folder = name.section(QLatin1Char('/'), 0, -2);
            if (++shares[folder] == 1 && found.isEmpty())
                found = name;
            else if (shares[folder] > 1 && found.section(QLatin1Char('/'), 0, -2) == folder)
                found.clear();
        }
        if (found.isEmpty())
            return {};
        QFile file;
        const QImage image = openToRead(file, m_trees + QLatin1Char('/') + found)
                                 ? QImage::fromData(file.readAll())
                                 : QImage();
        return image.isNull() ? image
                              : image.scaled(m_side, m_side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    }

    QImage grown(const QJsonObject& line)
    {
        if (line.contains(QStringLiteral("error")))
            return {};
        BatchRow row;
        row.input = line.value(QStringLiteral("input")).toString();
        if (!row.input.contains(QLatin1Char(':')))
            row.input = QDir(m_inputs).filePath(row.input);
        if (line.contains(QStringLiteral("seed")))
            row.seed = line.value(QStringLiteral("seed")).toInteger();
        for (const QJsonValue set : line.value(QStringLiteral("set")).toArray())
            row.sets << set.toString();
        auto input = inputOf(row);
        if (!input || !input->scene())
            return {};
        for (const Node& listed : input->scene()->nodes()) {
            NodeParams& params = std::get<Scene>(input->content).find(listed.id)->params;
            params.mesh.targetTriangles = std::int64_t(m_side) * m_side / pixelsATriangle;
        }
        if (!m_painter.hasBegun() && !m_painter.begin())
            return {};
        TreePipeline pipeline;
        Evaluator evaluator(pipelineSource(pipeline), input->scene()->timeline());
        EvaluatedScene now = evaluator.at(*input->scene());
        const auto scene = renderSceneOf(now);
        if (!scene)
            return {};
        const QSize size(m_side, m_side);
        RenderOptions options;
        options.hurried = true; // a leaf is less than a pixel
        options.sparing = true;
        options.shadows = false;
        options.samples = 0;
        options.smoothing = true;
        const auto image = m_painter.draw(*scene, cameraFor(*scene, size), size, options);
        return image ? *image : QImage();
    }

    QString m_trees, m_inputs;
    int m_side;
    Painter m_painter;
};

Expected<int> sideFrom(const CommandLine& line)
{
    bool isNumber = false;
    const int side = line.value("size").toInt(&isNumber);
    if (!isNumber || side < leastSide || side > mostSide)
        return fail(ErrorCode::Invalid, "--size \"%1\": %2 to %3 pixels expected",
                    {line.value("size").toStdString(), std::to_string(leastSide), std::to_string(mostSide)});
    return side;
}

void addSheetOptions(CommandLine& line)
{
    line.add({QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("The page."),
             QStringLiteral("FILE.html"));
    line.add({QStringLiteral("inputs")},
             QStringLiteral("Where the projects of the table stand; beside the manifest without it."),
             QStringLiteral("FOLDER"));
    line.addDefault({QStringLiteral("size")}, QStringLiteral("Of pictures, 32 to 1024; 160 without it."),
                    QStringLiteral("PIXELS"), QString::number(usualSide));
    addPoolOptions(line);
}

Expected<int> runSheet(const CommandLine& line)
{
    const QString manifest = line.arguments().front(), page = line.value("output");
    if (page.isEmpty())
        return fail(ErrorCode::Invalid,
                    "missing -o FILE.html: `ramure-cli sheet --help` shows what it takes");
    const auto side = sideFrom(line);
    RAMURE_TRY(side);
    const auto pool = poolOptionsOf(line);
    RAMURE_TRY(pool);
    const auto lines = readManifest(manifest);
    RAMURE_TRY(lines);
    const QString trees = QFileInfo(manifest).path();
    VirtualDisplay display; // one for all processes
    RAMURE_TRY(display.ensure());
    std::vector<ManifestLines::const_iterator> rows;
    for (auto row = lines->begin(); row != lines->end(); ++row)
        rows.push_back(row);
    std::map<std::int64_t, QByteArray> pictures;
    std::unique_ptr<Drawer> drawer; // of a process of the pool
    const auto draw = [&](std::size_t job) {
        if (!drawer)
            drawer =
                std::make_unique<Drawer>(trees, line.has("inputs") ? line.value("inputs") : trees, *side);
        return drawer->draw(rows[job]->second);
    };
    const int signal =
        runJobs(rows.size(), *pool, draw, [&](std::size_t job, JobEnd, const QByteArray& picture) {
            pictures[rows[job]->first] = picture;
            return true;
        });
    if (signal != 0)
        return 128 + signal;
    auto file = FileWriter::open(systemPath(page));
    RAMURE_TRY(file);
    file->append(sheetPage(*lines, pictures).toStdString());
    RAMURE_TRY(file->commit());
    return exitGood;
}

} // namespace

const Command sheetCommand{sheetText, &addSheetOptions, &runSheet, true};

} // namespace ramure::cli
