//! The words of an explanation, in the languages that it can be written in.

/// A language.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Russian.
    Russian,
}

impl Language {
    /// Every language.
    pub const ALL: [Self; 2] = [Self::English, Self::Russian];

    /// Its code: `en` or `ru`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Russian => "ru",
        }
    }

    /// The language of that code.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.word() == word)
    }

    pub(crate) const fn words(self) -> &'static Words {
        match self {
            Self::English => &ENGLISH,
            Self::Russian => &RUSSIAN,
        }
    }
}

/// Declares the table once and fills it for both languages, so that no word can be missing in one of them.
macro_rules! words {
    ($($name:ident: $english:literal, $russian:literal;)*) => {
        /// Everything that an explanation says.
        #[derive(Debug)]
        pub(crate) struct Words {
            $(pub(crate) $name: &'static str,)*
        }

        const ENGLISH: Words = Words { $($name: $english,)* };
        const RUSSIAN: Words = Words { $($name: $russian,)* };

        #[cfg(test)]
        const PAIRS: &[(&str, &str, &str)] = &[$((stringify!($name), $english, $russian),)*];
    };
}

words! {
    quote_open: "“", "«";
    quote_close: "”", "»";
    pixel: "Pixel", "Пиксель";
    of_scene: "of", "сцены";
    camera: "camera", "камера";
    picture: "picture", "изображение";
    pixels: "pixels", "пикселей";
    linear_color: "linear light", "линейный свет";
    screen_color: "on the screen", "на экране";
    how_it_is_made: "How the colour is made", "Как получается цвет";
    setting: "The scene's constants", "Постоянные сцены";
    ambient_light: "ambient light", "фоновое освещение";
    attenuation: "attenuation", "затухание";
    background: "background", "цвет фона";
    depth_limit: "depth", "глубина";
    light: "Light", "Источник";
    position: "position", "положение";
    intensity: "intensity", "интенсивность";
    color: "colour", "цвет";
    object: "object", "объект";
    samples: "Samples", "Лучи через пиксель";
    sample: "sample", "луч";
    film_place: "place in the picture", "место на изображении";
    lens_place: "place on the lens", "место на линзе";
    mean: "mean", "среднее";
    smallest: "smallest", "наименьшее";
    largest: "largest", "наибольшее";
    std_dev: "standard deviation", "стандартное отклонение";
    shown_sample: "The rays of one sample follow; the others are made in the same way. Sample",
        "Далее показаны лучи одной выборки, остальные устроены так же. Выборка";
    camera_ray: "Camera ray", "Луч камеры";
    mirror_ray: "Mirror ray", "Отражённый луч";
    shadow_ray: "shadow ray", "теневой луч";
    origin: "starts at", "начало";
    direction: "direction", "направление";
    depth: "surfaces before it", "поверхностей до него";
    weight: "share in the pixel", "доля в пикселе";
    hits: "hits", "попадает в";
    triangle: "triangle", "треугольник";
    face: "face", "грань";
    front: "front side", "лицевая сторона";
    back: "back side", "обратная сторона";
    at_distance: "at t =", "при t =";
    point: "point P", "точка P";
    geometric_normal: "true normal", "нормаль грани";
    normal: "normal N", "нормаль N";
    to_viewer: "to the viewer V", "к наблюдателю V";
    shading: "shading", "закраска";
    vertices: "vertices", "вершины";
    vertex: "vertex", "вершина";
    vertex_normals: "normals there", "нормали в них";
    weights: "weights", "веса";
    material: "material", "материал";
    second_square: "second colour of the pattern", "второй цвет узора";
    first_square: "first colour of the pattern", "первый цвет узора";
    gloss: "gloss", "блеск";
    meets_nothing: "meets nothing and brings the background", "ни с чем не встречается и приносит цвет фона";
    depth_used_up: "is not traced, since the depth is used up, and brings the background",
        "не прослеживается, так как глубина исчерпана, и приносит цвет фона";
    ambient_term: "Ambient term", "Фоновый член";
    direction_to_light: "to the light L", "к источнику L";
    mirrored_direction: "L mirrored at N, R", "отражение L от N, R";
    visible: "nothing stands between: the light counts", "ничто не заслоняет: источник учитывается";
    blocked_by: "blocked by", "заслонён объектом";
    adds_nothing: "the light adds nothing", "источник ничего не добавляет";
    behind: "the light is behind the surface and adds nothing", "источник за поверхностью и ничего не добавляет";
    no_strength: "the light adds nothing here", "источник здесь ничего не добавляет";
    would_add: "Without that it would add", "Иначе он добавил бы";
    matt: "no highlight, the surface is matt", "блика нет, поверхность матовая";
    mirrored_away: "no highlight, the mirrored light points away from the viewer",
        "блика нет, отражение источника направлено от наблюдателя";
    gouraud_note: "Gouraud: worked out at the three vertices and blended by the weights",
        "Гуро: вычисляется в трёх вершинах и смешивается по весам";
    local_sum: "Sum of the light", "Сумма света";
    mirror_mix: "Mixed with the mirror", "Смешение с отражением";
    mirrored_comes_from: "the mirrored colour is that of ray", "отражённый цвет приносит луч";
    brings: "The ray brings", "Луч приносит";
    mean_of_samples: "The pixel is the mean of its samples", "Пиксель — среднее по лучам";
    cosines: "A cosine below 0 counts as 0, and a light that something stands before adds nothing. Colours are linear light: red, green, blue.",
        "Косинус меньше 0 считается равным 0, а заслонённый источник ничего не добавляет. Цвета — линейный свет: красный, зелёный, синий.";
    meaning: "meaning", "значение";
    symbol: "symbol", "обозначение";
    met: "met", "встречено";
    corners: "corners", "углы";
    sym_ia: "ambient light", "фоновое освещение";
    sym_k: "distance at which a light has half its strength", "расстояние, на котором источник вдвое слабее";
    sym_i: "intensity of the light", "интенсивность источника";
    sym_c: "colour of the light", "цвет источника";
    sym_d: "distance to the light", "расстояние до источника";
    sym_theta: "angle between the normal and the light, N·L", "угол между нормалью и источником, N·L";
    sym_alpha: "angle between the mirrored light and the viewer, R·V", "угол между отражением источника и наблюдателем, R·V";
    sym_kd: "colour of the surface, k_a the same", "цвет поверхности, k_a тот же";
    sym_ks: "strength of the highlight", "сила блика";
    sym_n: "sharpness of the highlight", "резкость блика";
    sym_r: "share of the mirror", "доля отражения";
    sym_a: "attenuation", "затухание";
    sym_s: "strength of the light at the point, I_l / (d + K)", "сила источника в точке, I_l / (d + K)";
    sym_diffuse: "diffuse term", "диффузный член";
    sym_specular: "highlight", "зеркальный член (блик)";
    sym_share: "what light j adds", "вклад источника j";
    sym_local: "light of the surface itself", "собственный свет поверхности";
    sym_mirrored: "colour of the mirror ray", "цвет отражённого луча";
    sym_result: "what the ray brings", "что приносит луч";
    walk: "The way through the trees", "Путь по деревьям";
    boxes: "boxes entered", "вошёл в боксы";
    tests: "shapes tested", "проверено фигур";
    level: "level", "уровень";
    content: "content", "содержимое";
    more_boxes: "more boxes", "боксов";
    triangles_or_shapes: "shapes", "фигур";
    every_ray: "tested for every ray", "проверяется для каждого луча";
    met_at: "met at t =", "встречено при t =";
    corner_low: "from", "от";
    corner_high: "to", "до";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_there_in_both_languages() {
        for (name, english, russian) in PAIRS {
            assert!(!english.is_empty() && !russian.is_empty(), "{name}");
            let cyrillic = russian.chars().any(|c| ('а'..='я').contains(&c.to_lowercase().next().unwrap_or(c)));
            assert!(cyrillic || *name == "quote_open" || *name == "quote_close", "{name} is not Russian: {russian}");
            assert!(english.is_ascii() || name.starts_with("quote") || english.contains('·'), "{name}: {english}");
        }
    }

    #[test]
    fn languages_are_read_back() {
        for language in Language::ALL {
            assert_eq!(Language::from_word(language.word()), Some(language));
        }
        assert_eq!(Language::from_word("de"), None);
    }
}
