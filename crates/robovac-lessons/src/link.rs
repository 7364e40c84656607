//! A settings link as a list of pairs, and the runs that it stands for.

use robovac_sim::{
    experiment::{Algorithm, GENERATED},
    montecarlo::RunsRequest,
};

/// Keys of the view, which change no run.
const VIEW: [&str; 6] = ["speed", "show", "search", "tab", "lesson", "m"];

/// The pairs of a settings link: what stands behind `#` in the address of the page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Link(Vec<(String, String)>);

impl Link {
    /// Reads `room=flat&planner=snake`, with or without an address in front.
    pub fn parse(text: &str) -> Self {
        let pairs = text.rsplit('#').next().unwrap_or_default();
        let read = pairs.split('&').filter_map(|pair| pair.split_once('='));
        Self(read.map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned())).collect())
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.iter().rev().find(|(known, _)| known == key).map(|(_, value)| value.as_str())
    }

    /// The generated flat that is the room, if one is.
    pub fn flat(&self) -> Option<&str> {
        self.get("flat").filter(|_| self.get("room") == Some("own"))
    }

    /// Whether the user's own program drives or plans.
    pub fn is_program(&self) -> bool {
        self.algorithm().is_some_and(|(_, id)| Algorithm::is_program_id(id))
    }

    /// Key and id of the algorithm.
    fn algorithm(&self) -> Option<(&str, &str)> {
        self.pairs().filter(|(key, _)| matches!(*key, "planner" | "behaviour")).last()
    }

    /// The pairs.
    pub fn pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(key, value)| (key.as_str(), value.as_str()))
    }

    /// The pairs whose keys `stay`.
    #[must_use]
    pub fn keeping(&self, stays: impl Fn(&str) -> bool) -> Self {
        Self(self.0.iter().filter(|(key, _)| stays(key)).cloned().collect())
    }

    /// This link with the choices of `over` in front of its own. Another algorithm comes with its own parameters, another
    /// robot with its own planning cells.
    #[must_use]
    pub fn with(&self, over: &Self) -> Self {
        let replaces = |key: &str| over.get(key).is_some();
        let algorithm = replaces("planner") || replaces("behaviour");
        let stays = |key: &str| match key {
            "planner" | "behaviour" => !algorithm,
            "cell" | "own" | "twin" => !replaces(key) && !replaces("robot"),
            "flat" => !replaces(key) && !replaces("room"),
            _ => !(replaces(key) || algorithm && key.starts_with("p.")),
        };
        let all = || self.0.iter().filter(|(key, _)| stays(key)).chain(&over.0);
        // The algorithm before its parameters, the robot before its cells.
        let rank = |key: &str| match key {
            "room" | "planner" | "behaviour" | "robot" => 0,
            _ if key.starts_with("p.") => 2,
            _ => 1,
        };
        Self((0..3).flat_map(|now| all().filter(move |(key, _)| rank(key) == now)).cloned().collect())
    }

    /// Runs of `duration_s` seconds with the settings of the link. `scenario` is the room if the link names none.
    pub fn request(&self, scenario: Option<&str>, duration_s: f64, seeds: Vec<u64>) -> RunsRequest {
        let is_algorithm =
            |key: &str| matches!(key, "planner" | "behaviour" | "room" | "flat" | "seed") || key.starts_with("p.");
        let settings: Vec<String> = self
            .pairs()
            .filter(|(key, _)| !is_algorithm(key) && !VIEW.contains(key))
            .map(|(key, value)| format!("{key}={value}"))
            .collect();
        let (behaves, id) = self.algorithm().map_or((false, "boustrophedon"), |(key, id)| (key == "behaviour", id));
        let params = self.pairs().filter_map(|(key, value)| Some((key.strip_prefix("p.")?, value)));
        let params = params.fold(String::new(), |text, (id, value)| text + "~" + id + ":" + value);
        let room = self.flat().map(|flat| format!("{GENERATED}{flat}"));
        let room = room.or_else(|| self.get("room").map(str::to_owned)).filter(|_| scenario.is_none());
        let room = room.unwrap_or_else(|| "flat".to_owned());
        let plan_seed = self.get("seed").and_then(|seed| seed.parse().ok()).unwrap_or(1);
        let settings = settings.join("&");
        RunsRequest {
            id: 0,
            place: format!("{room} {} {settings} {} {plan_seed}", scenario.unwrap_or_default(), duration_s.to_bits()),
            room: scenario.is_none().then_some(room),
            scenario: scenario.map(str::to_owned),
            settings,
            duration_s,
            plan_seed,
            behaves,
            entrant: format!("{id}{params}"),
            seeds,
            job: None,
        }
    }
}

impl std::fmt::Display for Link {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, (key, value)) in self.pairs().enumerate() {
            write!(f, "{}{key}={value}", if index > 0 { "&" } else { "" })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_algorithm_comes_without_old_parameters() {
        let base = Link::parse("#room=living&robot=roomba600&planner=snake&p.patience=3&slip=typical");
        let link = base.with(&Link::parse("behaviour=bounce&p.angle=90"));
        assert_eq!(link.to_string(), "room=living&robot=roomba600&behaviour=bounce&slip=typical&p.angle=90");
        let request = link.request(None, 60.0, vec![1]);
        assert_eq!(
            (request.room.as_deref(), request.entrant.as_str(), request.behaves),
            (Some("living"), "bounce~angle:90", true)
        );
        assert_eq!(request.settings, "robot=roomba600&slip=typical");
    }
}
