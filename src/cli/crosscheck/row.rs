//! What is said about one scene, and about all of them.

use super::NoPicture;
use crate::cli::compare::decibels;
use crate::picture::compare::Difference;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// How a scene came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    Match,
    /// Below a match, but at least [`CLOSE_DB`].
    Close,
    Differs,
    /// Glint refused the scene.
    Error,
    /// Glint took too long.
    Timeout,
    /// Glint ended unexpectedly.
    Crash,
    /// There is no picture to compare with.
    ReferenceFailed,
}

/// From here on pictures are close.
const CLOSE_DB: f64 = 30.0;

impl Status {
    pub const ALL: [Status; 7] = [
        Status::Match,
        Status::Close,
        Status::Differs,
        Status::Error,
        Status::Timeout,
        Status::Crash,
        Status::ReferenceFailed,
    ];

    pub fn of(difference: &Difference, min_psnr: f64) -> Status {
        if difference.reaches(min_psnr) {
            Status::Match
        } else if difference.reaches(CLOSE_DB.min(min_psnr)) {
            Status::Close
        } else {
            Status::Differs
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Status::Match => "match",
            Status::Close => "close",
            Status::Differs => "differs",
            Status::Error => "error",
            Status::Timeout => "timeout",
            Status::Crash => "crash",
            Status::ReferenceFailed => "reference_failed",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// One scene. Times are CPU seconds; POV-Ray's are null where stored pictures were used.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub scene: String,
    pub status: Status,
    /// Null when the pictures are equal, and when there are none.
    pub psnr_db: Option<f64>,
    pub off_by_8_share: Option<f64>,
    pub glint_parse_cpu_s: Option<f64>,
    pub glint_prepare_cpu_s: Option<f64>,
    pub glint_trace_cpu_s: Option<f64>,
    pub povray_parse_cpu_s: Option<f64>,
    /// POV-Ray's bounding.
    pub povray_prepare_cpu_s: Option<f64>,
    /// Photons and radiosity included.
    pub povray_trace_cpu_s: Option<f64>,
    /// Glint's parse, prepare and trace over POV-Ray's.
    pub ratio: Option<f64>,
    /// What went wrong.
    pub message: Option<String>,
    pub unsupported: Vec<String>,
    /// Picture files for the report: POV-Ray's, Glint's, their difference.
    #[serde(skip)]
    pub pictures: [Option<Vec<u8>>; 3],
}

impl Row {
    pub fn new(scene: String) -> Self {
        Self {
            scene,
            status: Status::ReferenceFailed,
            psnr_db: None,
            off_by_8_share: None,
            glint_parse_cpu_s: None,
            glint_prepare_cpu_s: None,
            glint_trace_cpu_s: None,
            povray_parse_cpu_s: None,
            povray_prepare_cpu_s: None,
            povray_trace_cpu_s: None,
            ratio: None,
            message: None,
            unsupported: Vec::new(),
            pictures: [None, None, None],
        }
    }

    pub fn without(mut self, why: NoPicture) -> Self {
        self.status = why.status;
        self.message = Some(why.message);
        self
    }

    pub fn keep(
        &mut self,
        wanted: bool,
        povray: Option<&[u8]>,
        glint: Option<&[u8]>,
        difference: Option<&[u8]>,
    ) {
        if wanted {
            self.pictures = [povray, glint, difference].map(|p| p.map(<[u8]>::to_vec));
        }
    }

    pub fn glint_cpu_s(&self) -> Option<f64> {
        Some(self.glint_parse_cpu_s? + self.glint_prepare_cpu_s? + self.glint_trace_cpu_s?)
    }

    pub fn povray_cpu_s(&self) -> Option<f64> {
        Some(self.povray_parse_cpu_s? + self.povray_prepare_cpu_s.unwrap_or(0.0) + self.povray_trace_cpu_s?)
    }

    pub fn set_ratio(&mut self) {
        let positive = self.povray_cpu_s().filter(|&s| s > 0.0);
        self.ratio = self.glint_cpu_s().zip(positive).map(|(glint, povray)| glint / povray);
    }

    /// The row on the terminal.
    pub fn line(&self) -> String {
        let seconds = |s: Option<f64>| s.map_or("-".into(), |s| format!("{s:.2}"));
        let psnr = if self.off_by_8_share.is_some() { decibels(self.psnr_db) } else { "-".into() };
        let off = self.off_by_8_share.map_or("-".into(), |s| format!("{:.2}%", s * 100.0));
        let ratio = self.ratio.map_or("-".into(), |r| format!("{r:.2}"));
        let mut line = format!(
            "{:<16} {psnr:>6} dB {off:>7} off  glint {:>6} s  povray {:>6} s  ratio {ratio:>5}  {}",
            self.status,
            seconds(self.glint_cpu_s()),
            seconds(self.povray_cpu_s()),
            self.scene,
        );
        for note in self.message.iter().chain(&self.unsupported) {
            line.push_str(&format!("  [{note}]"));
        }
        line
    }
}

/// Scenes for which POV-Ray takes less say little about speed.
const SPEED_FLOOR_S: f64 = 0.2;

#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    pub scenes: usize,
    #[serde(flatten)]
    pub by_status: BTreeMap<&'static str, usize>,
    /// Geometric mean of the ratios of matching scenes for which POV-Ray takes at least 0.2 s.
    pub ratio_geometric_mean: Option<f64>,
    pub ratio_scenes: usize,
    /// What Glint does not render yet, and in how many scenes.
    pub unsupported: BTreeMap<String, usize>,
}

impl Summary {
    pub fn of(rows: &[Row]) -> Self {
        let count = |s: Status| rows.iter().filter(|r| r.status == s).count();
        let fair =
            |r: &&Row| r.status == Status::Match && r.povray_cpu_s().is_some_and(|s| s >= SPEED_FLOOR_S);
        let logs: Vec<f64> = rows.iter().filter(fair).filter_map(|r| r.ratio).map(f64::ln).collect();
        let mut unsupported = BTreeMap::new();
        for feature in rows.iter().flat_map(|r| &r.unsupported) {
            *unsupported.entry(feature.clone()).or_insert(0) += 1;
        }
        Self {
            scenes: rows.len(),
            by_status: Status::ALL.iter().map(|&s| (s.name(), count(s))).collect(),
            ratio_geometric_mean: (!logs.is_empty())
                .then(|| (logs.iter().sum::<f64>() / logs.len() as f64).exp()),
            ratio_scenes: logs.len(),
            unsupported,
        }
    }

    pub fn matches(&self) -> usize {
        self.by_status.get(Status::Match.name()).copied().unwrap_or(0)
    }

    /// The last lines on the terminal.
    pub fn text(&self) -> String {
        let counts = Status::ALL.iter().map(|s| (s.name(), self.by_status[s.name()])).filter(|(_, n)| *n > 0);
        let counts = counts.map(|(name, n)| format!("{n} {name}")).collect::<Vec<_>>().join(", ");
        let mut text = format!("{} scenes: {counts}\n", self.scenes);
        if let Some(ratio) = self.ratio_geometric_mean {
            text.push_str(&format!(
                "CPU seconds, Glint over POV-Ray: {ratio:.3} (geometric mean of {} matching scenes of {SPEED_FLOOR_S} s and more)\n",
                self.ratio_scenes
            ));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(psnr: Option<f64>) -> Difference {
        Difference { psnr_db: psnr, rmse: 0.0, max_abs: 0.0, off_by_8_share: 0.0 }
    }

    #[test]
    fn statuses_follow_the_psnr() {
        let of = |db| Status::of(&difference(db), 38.0);
        assert_eq!(of(None), Status::Match);
        assert_eq!([of(Some(38.0)), of(Some(37.9))], [Status::Match, Status::Close]);
        assert_eq!([of(Some(30.0)), of(Some(29.9))], [Status::Close, Status::Differs]);
        assert_eq!(Status::of(&difference(Some(26.0)), 25.0), Status::Match);
    }

    fn row(status: Status, glint: f64, povray: f64) -> Row {
        let mut row = Row::new("a".into());
        row.status = status;
        (row.glint_parse_cpu_s, row.glint_prepare_cpu_s, row.glint_trace_cpu_s) =
            (Some(0.0), Some(0.0), Some(glint));
        (row.povray_parse_cpu_s, row.povray_trace_cpu_s) = (Some(0.0), Some(povray));
        row.set_ratio();
        row
    }

    #[test]
    fn the_mean_ratio_is_of_matching_scenes_that_take_time() {
        let rows = [
            row(Status::Match, 0.1, 1.0),
            row(Status::Match, 0.4, 1.0),
            row(Status::Match, 0.1, 0.1),
            row(Status::Differs, 9.0, 1.0),
        ];
        let summary = Summary::of(&rows);
        assert!((summary.ratio_geometric_mean.unwrap() - 0.2).abs() < 1e-9);
        assert_eq!((summary.matches(), summary.ratio_scenes, summary.scenes), (3, 2, 4));
        let json = serde_json::to_value(&summary).unwrap();
        assert_eq!((&json["match"], &json["differs"], &json["crash"]), (&3.into(), &1.into(), &0.into()));
    }

    #[test]
    fn rows_have_the_names_that_scripts_read() {
        let json = serde_json::to_value(row(Status::ReferenceFailed, 1.0, 2.0)).unwrap();
        assert_eq!(json["status"], "reference_failed");
        for name in [
            "scene",
            "status",
            "psnr_db",
            "off_by_8_share",
            "glint_parse_cpu_s",
            "glint_trace_cpu_s",
            "povray_parse_cpu_s",
            "povray_trace_cpu_s",
        ] {
            assert!(json.get(name).is_some(), "{name}");
        }
    }
}
