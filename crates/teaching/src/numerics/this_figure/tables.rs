//! The numbers of a study for programs and spreadsheets.

use serde::{Serialize, Serializer};

use super::{Key, LeftOut, SAMPLES, Study, Value, WhyNot};

/// Keys with values, as one map.
struct Map<T>(Vec<(String, T)>);

impl<T: Serialize> Serialize for Map<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match *self {
            Self::Word(word) => serializer.serialize_str(word),
            Self::Number(number) if number.fract() == 0.0 =>
            {
                #[expect(clippy::cast_possible_truncation, reason = "a whole number of samples or texels, or a bias")]
                serializer.serialize_i64(number as i64)
            }
            Self::Number(number) => serializer.serialize_f64(number),
        }
    }
}

/// A study for programs: `camera-lab accuracy FIGURE --format json`.
#[derive(Serialize)]
struct Accuracy {
    size: [u32; 2],
    choices: Map<Vec<Value>>,
    left_out: Vec<Reason>,
    /// Sections of the figure that neither image shows.
    set_aside: Vec<&'static str>,
    reference: Reference,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Reason {
    key: String,
    reason: String,
}

#[derive(Serialize)]
struct Reference {
    samples: u32,
    rays: u64,
}

#[derive(Serialize)]
struct Row {
    set: Map<Value>,
    different: f64,
    wrong: f64,
    rms: f64,
    ms: [f64; 3],
    bytes: usize,
    front: bool,
    undecided: bool,
    yours: bool,
    cheapest: bool,
}

fn rows(study: &Study) -> impl Iterator<Item = Row> {
    study.ways.iter().enumerate().map(|(place, way)| Row {
        set: Map(study.set(way).map(|(key, value)| (key.path(), value)).collect()),
        different: way.cost.different,
        wrong: way.cost.wrong,
        rms: way.cost.rms,
        ms: [way.ms.median, way.ms.low, way.ms.high],
        bytes: way.cost.bytes,
        front: way.front,
        undecided: way.undecided,
        yours: place == study.yours,
        cheapest: place == study.cheapest,
    })
}

impl Study {
    /// The study as data. `why` gives the reason for a key that wasn't tried, in words.
    pub fn data(&self, why: impl Fn(WhyNot) -> String) -> impl Serialize {
        let left_out = |out: &LeftOut| Reason { key: out.key.clone(), reason: why(out.why) };
        Accuracy {
            size: self.size,
            choices: Map(self.choices.iter().map(|choice| (choice.key.path(), choice.values.clone())).collect()),
            left_out: self.left_out.iter().map(left_out).collect(),
            set_aside: self.set_aside.clone(),
            reference: Reference { samples: SAMPLES, rays: self.exact.rays },
            rows: rows(self).collect(),
        }
    }

    /// A line for each way: a column for each key, then the numbers.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn csv(&self) -> Result<String, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let numbers = "different wrong rms ms ms_low ms_high bytes front undecided yours cheapest".split(' ');
        let keys = self.choices.iter().map(|choice| choice.key.path());
        writer.write_record(keys.chain(numbers.map(str::to_owned)))?;
        for Row { set, different, wrong, rms, ms: [ms, low, high], bytes, front, undecided, yours, cheapest } in
            rows(self)
        {
            let values = set.0.iter().map(|(_, value)| value.to_string());
            let floats = [different, wrong, rms, ms, low, high].map(|number| number.to_string());
            let flags = [front, undecided, yours, cheapest].map(|flag| flag.to_string());
            writer.write_record(values.chain(floats).chain([bytes.to_string()]).chain(flags))?;
        }
        let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Word(word) => f.write_str(word),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}

impl std::fmt::Display for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.path())
    }
}
