//! Russian.

use super::{Numbers, SpeedUp, Text};
use crate::findings::Grows;
use crate::plan::{Effect, Kind, MAX_PIXELS, MAX_VALUES};
use crate::plan_error::{PlanError, Quantity};

pub(super) static TEXT: Text = Text {
    // Four digits are not grouped; a line does not break within a number.
    numbers: Numbers { decimal: ",", group: "\u{a0}", grouped_from: 5 },

    scene: |id| {
        Some(match id {
            "one-sphere" => "Одна сфера",
            "two-spheres" => "Две сферы",
            "knight" => "Конь, куб и сфера",
            "chess" => "Шахматы",
            "bumpy-sphere" => "Бугристая сфера",
            _ => return None,
        })
    },
    title: |kind| match kind {
        Kind::Threads => "Зависимость времени визуализации от числа потоков",
        Kind::Triangles => "Зависимость времени от числа треугольников",
        Kind::Rays => "Зависимость времени и шума от числа лучей на пиксель",
        Kind::Tiles => "Зависимость времени визуализации от размера плиток",
    },
    effect: |effect| match effect {
        Effect::Antialiasing => "по пикселю (сглаживание)",
        Effect::DepthOfField => "по линзе (глубина резкости)",
        Effect::Both => "по пикселю и по линзе (сглаживание и глубина резкости)",
    },

    plan_error,

    found: "Что обнаружено",
    results: "Результаты",
    growth: "Насколько другая сцена дороже",
    published: "Опубликованное исследование",
    method: "Как проводились измерения",
    machine: "Компьютер",

    threads: "Число потоков",
    threads_started: "Запущено",
    triangles: "Число треугольников",
    rays_per_pixel: "Лучей на пиксель",
    tile_side: "Сторона плитки",
    tile_side_axis: "Сторона плитки, пиксели",
    median_ms: "Медиана, мс",
    quartiles_ms: "Квартили, мс",
    minimum_ms: "Минимум, мс",
    cpu_ms: "Процессорное время, мс",
    build_ms: "Построение (квартили), мс",
    speed_up: "Ускорение",
    efficiency: "Эффективность",
    over_cores: "Сверх ядер, %",
    over_best: "Сверх лучшего, %",
    mray_per_s: "Млн лучей/с",
    noise: "Шум (СКО)",
    growth_percent: "рост, %",
    time_axis: "Время, мс",
    render_time_axis: "Время визуализации, мс",
    noise_axis: "Шум (СКО линейной яркости)",
    speed_up_axis: "Ускорение",
    mean: "Среднее",
    ms: "мс",

    plot_threads_all: "Время визуализации и число потоков",
    plot_threads_from_2: "Время визуализации начиная с двух потоков",
    plot_speed_up: "Ускорение относительно одного потока",
    plot_triangles: "Время и число треугольников",
    plot_rays_time: "Время визуализации и число лучей на пиксель",
    plot_rays_noise: "Шум и число лучей на пиксель",
    plot_tiles: "Время визуализации и размер плиток",
    ours: "Luch, этот компьютер",
    build: "Построение",
    render: "Визуализация",
    perfect: "Идеал, до числа ядер",
    published_series: |scene| format!("{scene}, опубликовано"),
    published_panel: |cpu| format!("Опубликовано: {cpu}, размер изображения не указан"),
    law_series: |scene| format!("{scene}, закон Амдала"),
    power_series: |what, exponent| format!("{what}, показатель степени {exponent}"),
    more_than_cores: |cores| format!("Потоков больше, чем у этого компьютера ядер ({cores})"),
    bars: "Медианы; отрезки — от нижнего квартиля до верхнего.",
    partial_short: "Неполно: исследование прервано.",

    processor: "Процессор",
    cores: "Ядра",
    hardware_threads: "Аппаратные потоки",
    usable_threads: "Доступные потоки",
    memory: "Память",
    gibibytes: |amount| format!("{amount} ГиБ"),
    simd: "Набор инструкций",
    system: "Система",
    program: "Программа",
    release: "выпускная сборка",
    debug: "отладочная сборка",
    load: "Загрузка до начала",
    began: "Начало",
    unknown: "неизвестно",
    cores_short: |count| format!("{count} {}", plural(count, ["ядро", "ядра", "ядер"])),

    partial: "**Неполно.** Исследование было прервано; всё ниже основано на запусках, сделанных к этому времени.",
    debug_build: "**Отладочная сборка.** Программа собрана не для скорости: эти времена мало говорят о выпускной сборке.",
    busy: |load| {
        format!(
            "**Компьютер был занят.** До начала исследования другие программы занимали потоков в среднем: {load}. Времена \
             завышены."
        )
    },
    found_speed_up: |SpeedUp { scene, one_ms, threads, ms, speed_up }| {
        let threads = format!("{threads} {}", plural(*threads, ["потоке", "потоках", "потоках"]));
        format!("**{scene}**: {one_ms} мс на одном потоке, {ms} мс на {threads}: быстрее в {speed_up} раза.")
    },
    found_law: |scene, percent, limit| match limit {
        Some(limit) => format!(
            "**{scene}**, закон Амдала: последовательная доля работы — {percent} %, и никакое число потоков не ускорит её \
             больше чем в {limit} раза."
        ),
        None => format!("**{scene}**, закон Амдала: последовательной доли работы измерения не обнаружили."),
    },
    found_growth: |from, to, percent| {
        format!("**{to}** по сравнению с «{from}»: {percent} % времени, в среднем по числу потоков.")
    },
    found_over_cores: |cores, percent| {
        format!("Если потоков больше, чем ядер ({cores}), медиана времени меняется в худшем случае на {percent} %.")
    },
    found_exponent: |grows, scene, exponent| {
        let of = scene.map(|scene| format!("**{scene}**. ")).unwrap_or_default();
        match grows {
            Grows::Render => format!("{of}Время визуализации растёт как степень с показателем {exponent}."),
            Grows::Build => format!("{of}Время построения растёт как степень с показателем {exponent}."),
            Grows::Noise => format!(
                "{of}Шум убывает как степень с показателем {exponent}; у независимых случайных лучей он равен \u{2212}0,5."
            ),
        }
    },
    found_best_tile: |scene, side, ms| format!("**{scene}**: быстрее всего плитки {side}×{side} пикселей, {ms} мс."),
    published_best: |scene, speed_up| {
        format!("**{scene}**: в лучшем случае быстрее, чем на одном потоке, в {speed_up} раза.")
    },
    published_caveat: |cpu, cores, threads| {
        format!(
            "Времена другой программы, как они опубликованы, на процессоре {cpu} (ядер: {cores}, потоков: {threads}). Размер \
             изображения не указан, и компьютер другой: сравнивать можно форму кривых, но не миллисекунды."
        )
    },
    method_time: "Измеряется только сама визуализация, от запуска первого потока до завершения последнего: чтение сцены, \
                  построение деревьев и запись файлов не входят.",
    method_build: "Время построения — всё, что готовит сетку к трассировке лучей: дерево и данные для закраски.",
    method_picture: |[width, height], simd| {
        format!("Изображения {width}×{height} пикселей с первой камеры сцены, набор инструкций {simd}.")
    },
    method_threads: |threads| format!("Число потоков: {threads}."),
    method_runs: |warm_up, runs| {
        format!(
            "Запусков для разогрева: {warm_up}, затем измеряемых запусков каждого варианта: {runs}. За один круг каждый \
             вариант запускается по разу; порядок кругов таков, что каждый вариант одинаково часто стоит на каждом месте и \
             сразу после каждого другого (Уильямс, 1949): дрейф компьютера не даёт преимущества никому."
        )
    },
    method_quartiles: "Квартили — по определению 7 Хайндмана и Фана (1996), как в NumPy, R и электронных таблицах.",
    method_started: "Потоки сверх тех, что компьютер выполняет одновременно, запускаются по одному, каждый — когда изображение \
                     строится уже так долго, что запуск стоит сотую долю этого времени; «запущено» — наибольшее число \
                     потоков, принявших участие в запуске.",
    method_law: |threads| {
        format!(
            "Закон Амдала, T(n) = T(1) (s + (1 \u{2212} s) / n), подобран к медианам для числа потоков {threads}, то есть пока \
             каждому потоку хватает своего ядра, методом наименьших квадратов для a + b / n; s = a / (a + b)."
        )
    },
    method_law_exact: "Два числа потоков определяют закон полностью: он проходит через обе точки и ими не проверяется.",
    method_efficiency: "Ускорение — отношение медианы на одном потоке к медиане на n потоках; эффективность — ускорение, \
                        делённое на n.",
    method_over_cores: |threads, cores| {
        format!(
            "«Сверх ядер» — на сколько дольше, чем при наибольшем измеренном числе потоков, у каждого из которых есть своё ядро \
             (потоков: {threads}, ядер: {cores})."
        )
    },
    method_noise: |effect, reference| {
        format!(
            "Лучи распределены {effect}. Шум — среднеквадратичное отклонение линейной яркости от изображения с числом лучей \
             на пиксель {reference}. Лучи каждого изображения — первые из лучей эталона, поэтому шум n лучей занижен примерно \
             в \u{221a}(1 \u{2212} n/{reference}) раз."
        )
    },
    method_exponent: "Показатель степени — наклон прямой, проведённой через логарифмы методом наименьших квадратов.",
    method_meshes: "Каждая сетка — бугристая сфера, созданная для исследования: та же форма из меньших треугольников.",
    more: "Каждый столбец study.csv и каждый ключ study.json объясняет docs/study.md из состава Luch.",
};

fn plan_error(error: &PlanError) -> String {
    let a_number = |quantity| match quantity {
        Quantity::Threads => "число потоков",
        Quantity::Triangles => "число треугольников",
        Quantity::Rays => "число лучей на пиксель",
        Quantity::Tiles => "сторона плитки в пикселях",
        Quantity::Runs => "число запусков",
        Quantity::WarmUp => "число запусков для разогрева",
    };
    match error {
        PlanError::NoValues(quantity) => {
            format!("нечего измерять: не задано ни одно значение величины «{}»", a_number(*quantity))
        }
        PlanError::TooManyValues { quantity, count } => format!(
            "слишком много значений величины «{}»: {count}, а в исследовании их может быть не больше {MAX_VALUES}",
            a_number(*quantity)
        ),
        PlanError::OutOfRange { quantity, value, least, most } => {
            format!("{}: {value} вне пределов от {least} до {most}", a_number(*quantity))
        }
        PlanError::Twice { quantity, value } => format!("{}: значение {value} задано дважды", a_number(*quantity)),
        PlanError::SameMesh { wanted: [a, b], triangles } => format!(
            "для {a} и {b} треугольников получилась бы одна и та же сетка, в ней {triangles}: оставьте одно из чисел"
        ),
        PlanError::Reference { reference, most } => format!(
            "у эталона должно быть больше лучей на пиксель, чем у сравниваемых с ним изображений ({most}); {reference} \
             недостаточно"
        ),
        PlanError::TooLarge { width, height } => format!(
            "изображения {width}×{height} пикселей слишком велики для исследования, в котором их много: не больше \
             {MAX_PIXELS} пикселей, как 7680×4320"
        ),
        PlanError::NoScene => "нечего измерять: не задана ни одна сцена".to_owned(),
        PlanError::TooManyScenes { count } => {
            format!("слишком много сцен: {count}, а в исследовании их может быть не больше {MAX_VALUES}")
        }
        PlanError::SceneTwice(id) => format!("сцена {id} задана дважды"),
        PlanError::NoCamera(id) => format!("в сцене {id} нет камеры"),
    }
}

/// The form of a noun beside a number: of one, of few, of many.
const fn plural(count: u32, [one, few, many]: [&'static str; 3]) -> &'static str {
    match (count % 10, count % 100) {
        (_, 11..=14) => many,
        (1, _) => one,
        (2..=4, _) => few,
        _ => many,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nouns_follow_their_number() {
        for (count, text) in
            [(1, "1 ядро"), (2, "2 ядра"), (5, "5 ядер"), (11, "11 ядер"), (21, "21 ядро"), (112, "112 ядер")]
        {
            assert_eq!((TEXT.cores_short)(count), text);
        }
    }
}
