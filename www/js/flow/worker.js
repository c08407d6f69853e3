// The worker of the page of flows.

import { serveAnswers } from "../common/answering.js";
import { answer } from "./answers.js";

serveAnswers(answer);
